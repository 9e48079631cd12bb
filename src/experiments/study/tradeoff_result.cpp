#include "study/tradeoff_result.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "measure/statistics.h"

namespace fissure {

namespace {

/// Differences between rungs of at most this share of the tolerance count as none.
constexpr double negligible_share = 1e-3;

double numberOf(const CurveError& error, ErrorMeasure measure) {
  return measure == ErrorMeasure::rms ? error.rms : measure == ErrorMeasure::worst ? error.worst : error.peak;
}

double peakOf(const StudyRecord& record, ErrorQuantity quantity, std::size_t error) {
  return quantity == ErrorQuantity::shape ? largestDisplacement_m(record.shape) : record.curves[error].peak();
}

JudgedReference judgeQuantity(const TradeoffStudy& study, std::size_t error,
                              const std::vector<StudyRecord>& rungs) {
  JudgedReference judged;
  judged.error = error;
  const StudyError& of = study.errors[error];
  const std::vector<double>& sizes = study.reference.sizes;
  for (std::size_t i = 0; i + 1 < rungs.size(); ++i)
    judged.differences.push_back(numberOf(errorOf(rungs[i], rungs[i + 1], of.quantity, error), of.measure));
  judged.peak = peakOf(rungs.back(), of.quantity, error);
  judged.tolerance = of.size.absolute(judged.peak);
  judged.refinement =
      refinementOf(sizes, judged.differences, negligible_share * judged.tolerance, unitOf(of.quantity));
  if (!(judged.tolerance > 0) && judged.refinement.refused.empty())
    judged.refinement.refused = "its peak is 0, of which a tolerance in % is nothing";
  const std::size_t last = sizes.size() - 1;
  if (judged.refinement.refused.empty() && std::isfinite(judged.refinement.order))
    judged.peak_limit = richardson(peakOf(rungs[last - 1], of.quantity, error), judged.peak, sizes[last - 1],
                                   sizes[last], judged.refinement.order);
  return judged;
}

const std::vector<double>& timesOf(const TradeoffRun& run, const char* name) {
  static const std::vector<double> none;
  const auto found = run.timing.find(name);
  return found == run.timing.end() ? none : found->second;
}

/// The products of the numbers of two lists, one per repeat; as many as the shorter list has.
std::vector<double> products(const std::vector<double>& of, const std::vector<double>& by) {
  std::vector<double> all;
  for (std::size_t i = 0; i < std::min(of.size(), by.size()); ++i) all.push_back(of[i] * by[i]);
  return all;
}

SettingCost costOf(const TradeoffRun& run, double end_s) {
  const std::vector<double>& mean_us = timesOf(run, "mean_step_us");
  const std::vector<double>& p99_us = timesOf(run, "p99_step_us");
  std::vector<double> steps_per_ms, processor_s_per_s;
  const std::vector<double>& real_time = timesOf(run, "real_time_factor");
  for (std::size_t i = 0; i < std::min(mean_us.size(), real_time.size()); ++i)
    steps_per_ms.push_back(1e3 / (real_time[i] * mean_us[i]));
  for (const double processor_s : timesOf(run, "worker_processor_s"))
    processor_s_per_s.push_back(processor_s / end_s);
  return {spreadOf(mean_us),
          spreadOf(p99_us),
          spreadOf(products(mean_us, steps_per_ms)),
          spreadOf(products(p99_us, steps_per_ms)),
          spreadOf(processor_s_per_s),
          spreadOf(timesOf(run, "worker_memory_mb"))};
}

}  // namespace

const JudgedReference* TradeoffResult::referenceOf(const std::string& pipeline, std::size_t error) const {
  const JudgedReference* only = nullptr;
  std::size_t found = 0;
  for (const JudgedReference& reference : references) {
    if (reference.error != error) continue;
    if (reference.pipeline == pipeline) return &reference;
    only = &reference;
    ++found;
  }
  return found == 1 ? only : nullptr;
}

std::vector<JudgedReference> judgeLadder(const TradeoffStudy& study, const std::vector<TradeoffRun>& rungs,
                                         FinestRungs& finest) {
  std::map<std::string, std::vector<const TradeoffRun*>> ladders;
  for (const TradeoffRun& rung : rungs) ladders[rung.pipeline].push_back(&rung);
  std::vector<JudgedReference> judged;
  for (const auto& [pipeline, runs] : ladders) {
    const auto failed = std::find_if(runs.begin(), runs.end(),
                                     [](const TradeoffRun* run) { return run->status.end != RunEnd::ok; });
    std::vector<StudyRecord> records;
    for (const TradeoffRun* run : runs)
      if (failed == runs.end()) records.push_back(readRecord(run->file, pipeline, study.errors));
    for (std::size_t error = 0; error < study.errors.size(); ++error) {
      JudgedReference of;
      of.error = error;
      if (failed != runs.end())
        of.refinement.refused =
            fmt::format("rung {} of its ladder is {}", (*failed)->point + 1, nameOf((*failed)->status.end));
      else if (records.size() != study.reference.sizes.size())
        of.refinement.refused = "rungs of its ladder are the same simulation";
      else
        of = judgeQuantity(study, error, records);
      of.pipeline = pipeline;
      judged.push_back(std::move(of));
    }
    if (!records.empty()) finest[pipeline] = std::move(records.back());
  }
  return judged;
}

JudgedSetting judgeSetting(const TradeoffStudy& study, const TradeoffRun& run,
                           const std::vector<std::string>& values, const TradeoffResult& result,
                           const FinestRungs& finest) {
  JudgedSetting setting;
  setting.values = values;
  setting.pipeline = run.pipeline;
  setting.status = run.status;
  setting.file = run.file;
  setting.differences.resize(study.errors.size());
  setting.errors.assign(study.errors.size(), kMissing);
  if (run.status.end != RunEnd::ok) return setting;
  const StudyRecord record = readRecord(run.file, run.pipeline, study.errors);
  setting.cost = costOf(run, record.end_s);
  std::size_t judged = 0;
  setting.score = 0;
  for (std::size_t error = 0; error < study.errors.size(); ++error) {
    const StudyError& of = study.errors[error];
    const JudgedReference* reference = result.referenceOf(run.pipeline, error);
    const auto finest_rung = reference ? finest.find(reference->pipeline) : finest.end();
    if (finest_rung == finest.end()) continue;
    setting.differences[error] = errorOf(record, finest_rung->second, of.quantity, error);
    if (!reference->refinement.refused.empty()) continue;
    setting.errors[error] = numberOf(setting.differences[error], of.measure);
    const double weighed = std::isnan(setting.errors[error])
                               ? kMissing
                               : std::max(setting.errors[error], reference->refinement.error);
    if (!(weighed / reference->tolerance <= setting.score)) setting.score = weighed / reference->tolerance;
    if (std::isnan(setting.score)) return setting;
    ++judged;
  }
  if (judged == 0) setting.score = kMissing;
  return setting;
}

const Spread& costOf(const JudgedSetting& setting, CostMeasure measure) {
  return measure == CostMeasure::mean ? setting.cost.us_per_ms : setting.cost.p99_us_per_ms;
}

double excessOf(const JudgedSetting& setting, const TradeoffStudy& study, const TradeoffResult& result,
                const std::vector<ErrorLimit>& limits) {
  double excess = 0;
  for (const ErrorLimit& limit : limits) {
    std::size_t error = 0;
    while (error < study.errors.size() && study.errors[error].quantity != limit.quantity) ++error;
    if (error == study.errors.size()) return kMissing;
    const JudgedReference* reference = result.referenceOf(setting.pipeline, error);
    if (!reference || std::isnan(setting.errors[error])) return kMissing;
    const double sum = setting.errors[error] + reference->refinement.error;
    const double over = sum / limit.size.absolute(reference->peak);
    if (std::isnan(over)) return kMissing;
    excess = std::max(excess, over);
  }
  return excess;
}

void markFront(std::vector<JudgedSetting>& settings, CostMeasure cost) {
  std::vector<double> costs, scores;
  for (const JudgedSetting& setting : settings) {
    costs.push_back(costOf(setting, cost).median);
    scores.push_back(setting.score);
  }
  const std::vector<bool> front = paretoFront(costs, scores);
  for (std::size_t i = 0; i < settings.size(); ++i) settings[i].front = front[i];
}

TradeoffResult judgeStudy(const TradeoffStudy& study, const StudyPart& settings, const StudyPart& ladder,
                          CostMeasure cost) {
  TradeoffResult result;
  FinestRungs finest;
  result.references = judgeLadder(study, ladder.runs(), finest);
  const StudyPoints points = settingsOf(study);
  result.paths = points.paths;
  for (const TradeoffRun& run : settings.runs())
    result.settings.push_back(judgeSetting(study, run, points.values[run.point], result, finest));
  markFront(result.settings, cost);
  result.orders = ordersOf(study, result);
  return result;
}

}  // namespace fissure
