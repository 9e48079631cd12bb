#include "study/tradeoff_answer.h"

#include <fmt/core.h>

#include <cmath>

#include "base/error.h"
#include "table/sweep_names.h"
#include "text/lists.h"
#include "text/units.h"

namespace fissure {

namespace {

std::string costText(const JudgedSetting& setting, CostMeasure cost) {
  const Spread& of = costOf(setting, cost);
  return fmt::format("{:.4g} us for a simulated millisecond ({:.4g} to {:.4g})", of.median, of.low, of.high);
}

std::string errorsText(const JudgedSetting& setting, const TradeoffStudy& study,
                       const TradeoffResult& result) {
  std::string text;
  for (std::size_t error = 0; error < study.errors.size(); ++error) {
    const JudgedReference* reference = result.referenceOf(setting.pipeline, error);
    if (!reference || std::isnan(setting.errors[error])) continue;
    const std::string unit = unitOf(study.errors[error].quantity);
    text +=
        fmt::format("{}{} {} (reference {})", text.empty() ? "" : ", ", nameOf(study.errors[error].quantity),
                    withUnit(setting.errors[error], unit), withUnit(reference->refinement.error, unit));
  }
  return text;
}

/// What keeps any setting from a wish: a reference that is not known to its limit.
std::string tooCoarseText(const TradeoffWish& wish, const JudgedSetting& setting, const TradeoffStudy& study,
                          const TradeoffResult& result) {
  for (const ErrorLimit& limit : wish.limits)
    for (std::size_t error = 0; error < study.errors.size(); ++error) {
      if (study.errors[error].quantity != limit.quantity) continue;
      const JudgedReference* reference = result.referenceOf(setting.pipeline, error);
      if (reference && reference->refinement.error >= limit.size.absolute(reference->peak))
        return fmt::format("; no setting can be: the reference itself is known to {} in {}",
                           withUnit(reference->refinement.error, unitOf(limit.quantity)),
                           nameOf(limit.quantity));
    }
  return "";
}

/// Why no setting can be judged by a wish.
std::string unknownText(const TradeoffWish& wish, const TradeoffStudy& study, const TradeoffResult& result) {
  for (const ErrorLimit& limit : wish.limits)
    for (const JudgedReference& reference : result.references)
      if (study.errors[reference.error].quantity == limit.quantity && !reference.refinement.refused.empty())
        return fmt::format("{} has no reference: {}", nameOf(limit.quantity), reference.refinement.refused);
  return "none has both a cost and an error that is known";
}

}  // namespace

std::string TradeoffWish::text() const {
  if (budget_us) return fmt::format("at most {:.6g} us for a simulated millisecond", *budget_us);
  std::string text;
  for (const ErrorLimit& limit : limits)
    text += fmt::format("{}{} at most {}", text.empty() ? "" : ", ", nameOf(limit.quantity),
                        textOf(limit.size, limit.quantity));
  return text;
}

void refuseUnjudged(const TradeoffStudy& study, const std::vector<ErrorLimit>& limits) {
  std::vector<std::string_view> judged;
  for (const StudyError& error : study.errors)
    judged.push_back(errorQuantities()[static_cast<std::size_t>(error.quantity)].name);
  for (const ErrorLimit& limit : limits) {
    bool found = false;
    for (const StudyError& error : study.errors) found |= error.quantity == limit.quantity;
    if (!found)
      throw InputError(fmt::format("--max-error: {} does not judge {}, expected {}", study.file.string(),
                                   nameOf(limit.quantity), inWords(judged, "or")));
  }
}

TradeoffAnswer answerOf(const TradeoffWish& wish, const TradeoffStudy& study, const TradeoffResult& result,
                        CostMeasure cost) {
  std::vector<double> costs, scores, excess;
  for (const JudgedSetting& setting : result.settings) {
    const Spread& of = costOf(setting, cost);
    costs.push_back(wish.budget_us ? of.high : of.median);
    scores.push_back(setting.score);
    excess.push_back(excessOf(setting, study, result, wish.limits));
  }
  TradeoffAnswer answer;
  answer.wish = wish;
  answer.choice = wish.budget_us ? mostAccurate(costs, scores, *wish.budget_us) : cheapest(costs, excess);
  return answer;
}

bool fulfils(const JudgedSetting& setting, const TradeoffWish& wish, const TradeoffStudy& study,
             const TradeoffResult& result, CostMeasure cost) {
  if (wish.budget_us) return std::isfinite(setting.score) && costOf(setting, cost).median <= *wish.budget_us;
  return excessOf(setting, study, result, wish.limits) <= 1;
}

std::string settingText(const JudgedSetting& setting, const TradeoffResult& result) {
  const std::vector<std::string> names = sweepAxisNames(result.paths, {});
  std::string text = setting.pipeline;
  for (std::size_t p = 0; p < result.paths.size(); ++p)
    text += fmt::format("{}{} {}", p == 0 ? " with " : ", ", names[p], setting.values[p]);
  return text;
}

std::vector<Override> overridesOf(const JudgedSetting& setting, const TradeoffResult& result) {
  std::vector<Override> overrides;
  for (std::size_t p = 0; p < result.paths.size(); ++p)
    overrides.push_back({result.paths[p], setting.values[p]});
  return overrides;
}

std::string answerText(const TradeoffAnswer& answer, const TradeoffStudy& study, const TradeoffResult& result,
                       CostMeasure cost) {
  const std::string wish = answer.wish.text();
  if (!answer.choice.best && !answer.choice.nearest)
    return fmt::format("{}: no setting, {}", wish, unknownText(answer.wish, study, result));
  const JudgedSetting& setting =
      result.settings[answer.choice.best.value_or(answer.choice.nearest.value_or(0))];
  const std::string what = settingText(setting, result);
  if (!answer.choice.best)
    return fmt::format("{}: no setting; the nearest, {}, is {:.3g} times beyond: {}; {}{}", wish, what,
                       answer.choice.times_over, costText(setting, cost), errorsText(setting, study, result),
                       tooCoarseText(answer.wish, setting, study, result));
  std::string text =
      fmt::format("{}: {}: {}; {}", wish, what, costText(setting, cost), errorsText(setting, study, result));
  if (!answer.file.empty()) text += fmt::format("\n  fissure run {}", answer.file.string());
  if (answer.again)
    text += fmt::format("\n  run again: {}{}", answer.holds ? "holds: " : "DOES NOT HOLD: ",
                        answer.again->status.end == RunEnd::ok
                            ? costText(*answer.again, cost) + "; " + errorsText(*answer.again, study, result)
                            : nameOf(answer.again->status.end));
  return text;
}

}  // namespace fissure
