#include "fit/law_fit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/counted.h"
#include "base/error.h"
#include "fit/fit_intervals.h"
#include "fit/fit_problem.h"
#include "text/units.h"

namespace fissure {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNegligibleShare_s_m = 0.1;
constexpr double kLeastReliability = 0.9;
constexpr double kLargestNextCorrelation = 0.2;  // beyond it intervals are a fifth too narrow, and more

std::string namesOf(ForceModel law, const std::vector<FitParameter>& parameters) {
  std::string text;
  for (const FitParameter parameter : parameters) text += (text.empty() ? "" : ", ") + nameOf(law, parameter);
  return text;
}

/// `of_damping`: why that is not free any more, if so.
void refuseTooFew(const FitData& data, const FitSettings& settings, const std::string& of_damping) {
  const auto free = static_cast<std::size_t>(std::count(settings.free.begin(), settings.free.end(), true));
  const auto points = static_cast<std::size_t>(data.force_N.size());
  if (free == 0 && !of_damping.empty())
    throw InputError(
        fmt::format("{} cannot be identified from this data: {}, and nothing else is free, expected another "
                    "coefficient to fit",
                    nameOf(data.model.law(), FitParameter::damping), of_damping));
  if (free == 0) throw InputError("nothing is free, expected a coefficient to fit");
  if (points <= free)
    throw InputError(fmt::format("{} for {} free coefficients, expected more points than these",
                                 counted(points, "point"), free));
}

/// Throws InputError where the law with its fixed shape has no force above 0 at the measured depths.
void refuseOverflow(const FitProblem& problem, const FitSettings& settings) {
  const double force = problem.forceOfUnitK(settings.fixed);
  if (std::isfinite(force) && force > 0) return;
  throw InputError("the law's elastic force is no number above 0 at these depths, expected a smaller " +
                   std::string(problem.law().find(CoefficientRole::shape)->name));
}

LawFit measure(const FitProblem& problem, const LeastSquares& best, const FitData& data) {
  const FitValues values = problem.valuesAt(best.place);
  if (problem.elasticShare(values) < 1e-6)
    throw InputError("the force does not grow with the depth, expected one that does");
  const FitIntervals intervals(problem, best);
  if (!(intervals.singularValueRatio() > FitIntervals::least_ratio))
    throw InputError(
        fmt::format("the data does not determine {} (singular value ratio {}), expected other depths, or "
                    "fewer of them free",
                    namesOf(data.model.law(), problem.free()), fourDigits(intervals.singularValueRatio())));
  LawFit fit;
  fit.model = data.model.law();
  for (auto& row : fit.correlation) row.fill(kNone);
  for (const FitParameter parameter : kFitParameters)
    fit.values[index(parameter)] = {
        .value = hasParameter(fit.model, parameter) ? valueOf(fit.model, values, parameter) : 0,
        .standard_error = kNone,
        .low = kNone,
        .high = kNone};
  for (const FitParameter a : problem.free()) {
    fit.values[index(a)] = intervals.of(a);
    for (const FitParameter b : problem.free())
      fit.correlation[index(a)][index(b)] = a == b ? 1 : intervals.correlation(a, b);
  }
  const bool share = fit.of(FitParameter::damping).free && entryOf(fit.model).damping_grows_with_elastic;
  fit.lambda_over_k_s_m = share ? problem.viscousShare_s_m(values) : kNone;
  fit.lambda_over_k_half_width_s_m = share ? intervals.halfWidthOfViscousShare_s_m() : kNone;
  fit.points = static_cast<std::size_t>(problem.points());
  fit.free_count = static_cast<int>(problem.free().size());
  fit.rms_N = std::sqrt(best.sum_of_squares / static_cast<double>(fit.points));
  fit.r_squared = 1 - best.sum_of_squares / data.squares_around_mean_N2;
  fit.singular_value_ratio = intervals.singularValueRatio();
  fit.converged = best.converged;
  const Eigen::VectorXd residuals = problem.residuals(best.place);
  const Eigen::Index pairs = residuals.size() - 1;
  fit.next_correlation =
      best.sum_of_squares > 0 ? residuals.head(pairs).dot(residuals.tail(pairs)) / best.sum_of_squares : 0;
  return fit;
}

/// Whether the data says what the damping is.
struct DampingVerdict {
  std::string problem;  ///< why it does not; empty: it does
  std::string note;     ///< what is wrong with it, or why it is known only roughly
};

DampingVerdict judgeDamping(const FitProblem& problem, const LeastSquares& best, const std::string& name) {
  const FitIntervals intervals(problem, best);
  if (!(intervals.singularValueRatio() > FitIntervals::least_ratio))
    return {fmt::format("k and {} do the same (singular value ratio {}), as where all rates are the same",
                        name, fourDigits(intervals.singularValueRatio())),
            ""};
  const double reliability = intervals.rateReliability();
  if (!(reliability >= kLeastReliability))
    return {fmt::format("noise of the depths makes too much of the rates (reliability {}, expected {}), "
                        "expected smoother or fewer points",
                        fourDigits(reliability), fourDigits(kLeastReliability)),
            ""};
  const double share = problem.viscousShare_s_m(problem.valuesAt(best.place));
  const double half_width = intervals.halfWidthOfViscousShare_s_m();
  // c/k of a damper has another unit: what is judged is its force at 1 m/s over the elastic one.
  const std::string quotient = problem.law().damping_grows_with_elastic
                                   ? name + "/k"
                                   : name + " over the elastic force at the typical depth";
  const std::string interval = fmt::format("the 95 % interval of {}, {} to {} s/m, ", quotient,
                                           fourDigits(share - half_width), fourDigits(share + half_width));
  if (share + half_width < 0)
    return {"", name + " is negative, which is unphysical: are force and depth recorded at one time?"};
  if (half_width <= kNegligibleShare_s_m || half_width <= std::abs(share) / 2) return {};
  if (half_width >= std::abs(share))
    return {fmt::format("{}holds 0 and is wider than +-{} s/m", interval, fourDigits(kNegligibleShare_s_m)),
            ""};
  return {"", fmt::format("{} is known only roughly: {}is wider than half its value to either side", name,
                          interval)};
}

void judgeOthers(const FitProblem& problem, const FitData& data, LawFit& fit) {
  const auto hardly = [](const std::string& why, FittedValue& value) {
    if (value.free && value.problem.empty()) value.problem = why;
  };
  const auto free = static_cast<double>(fit.free_count), points = static_cast<double>(fit.points);
  const double numerator = std::max(1.0, free - 1);
  const double residual_N2 = (1 - fit.r_squared) * data.squares_around_mean_N2;
  if (residual_N2 > 0 && fit.of(FitParameter::offset).free) {  // else no constant force is among the fits
    const double explained_N2 = std::max(0.0, data.squares_around_mean_N2 - residual_N2);
    const double f = explained_N2 / numerator / (residual_N2 / (points - free));
    const double chance = fisherTail(f, numerator, points - free);
    if (!(chance <= 0.05)) {
      const std::string why =
          fmt::format("the force hardly changes with the depth: a constant one fits as well (F test, p = {})",
                      fourDigits(chance));
      hardly(why, fit.values[index(FitParameter::elastic)]);
      hardly(why, fit.values[index(FitParameter::shape)]);
    }
  }
  FittedValue& shape = fit.values[index(FitParameter::shape)];
  if (shape.low <= problem.leastShape() || shape.high >= problem.largestShape())
    hardly(fmt::format("its 95 % interval reaches the limit of what is searched, {} to {}",
                       fourDigits(problem.leastShape()), fourDigits(problem.largestShape())),
           shape);
  for (FittedValue& value : fit.values)
    if (value.free && (!std::isfinite(value.low) || !std::isfinite(value.high)))
      hardly("its 95 % interval has no end", value);
}

void addNotes(LawFit& fit) {
  for (const FitParameter parameter : kFitParameters)
    if (!fit.of(parameter).problem.empty())
      fit.notes.push_back(fmt::format("{} cannot be identified from this data: {}",
                                      nameOf(fit.model, parameter), fit.of(parameter).problem));
  const double most = std::max(kLargestNextCorrelation, 2.33 / std::sqrt(static_cast<double>(fit.points)));
  if (fit.points >= 20 && fit.next_correlation > most)
    fit.notes.push_back(
        fmt::format("residuals of neighbouring points are alike (correlation {}): the law or the data is off "
                    "by more than noise, the intervals are too narrow",
                    fourDigits(fit.next_correlation)));
  if (!fit.converged) fit.notes.emplace_back("the search for the least squares has not converged");
}

using Problems = std::array<std::string, kFitParameters.size()>;  // by FitParameter

LawFit describe(const FitProblem& problem, const LeastSquares& best, const FitData& data,
                const Problems& problems, const std::string& note) {
  LawFit fit = measure(problem, best, data);
  for (std::size_t i = 0; i < problems.size(); ++i) fit.values[i].problem = problems[i];
  judgeOthers(problem, data, fit);
  if (!note.empty()) fit.notes.push_back(note);
  addNotes(fit);
  return fit;
}

}  // namespace

FitValues LawFit::law() const {
  FitValues law;
  for (const FitParameter parameter : kFitParameters)
    if (hasParameter(model, parameter)) valueOf(model, law, parameter) = of(parameter).value;
  return law;
}

LawFit fitLaw(const LawModel& model, std::span<const double> force_N, std::span<const double> weights,
              const FitSettings& settings) {
  const FitData data(model, force_N, weights);
  const ForceModel law = model.law();
  FitSettings used = settings;
  bool& damping_free = used.free[index(FitParameter::damping)];
  bool& shape_free = used.free[index(FitParameter::shape)];
  Problems problems;
  std::string& of_damping = problems[index(FitParameter::damping)];
  std::string& of_shape = problems[index(FitParameter::shape)];
  if (damping_free && !(model.rateScale_m_s() > 0)) {
    of_damping = "there is no rate of the depth in it; it is fixed at " +
                 fourDigits(valueOf(law, used.fixed, FitParameter::damping));
    damping_free = false;
  }
  for (;;) {
    refuseTooFew(data, used, of_damping);
    const FitProblem problem(data, used);
    if (!shape_free) refuseOverflow(problem, used);
    const LeastSquares best = problem.solve();
    if (shape_free) {
      if (const std::optional<double> limit = problem.limitOfShape(problem.valuesAt(best.place))) {
        of_shape =
            fmt::format("the least squares lie at a limit of what is searched, {} to {}; it is fixed there",
                        fourDigits(problem.leastShape()), fourDigits(problem.largestShape()));
        valueOf(law, used.fixed, FitParameter::shape) = *limit;
        shape_free = false;
        continue;
      }
    }
    const DampingVerdict verdict =
        damping_free ? judgeDamping(problem, best, nameOf(law, FitParameter::damping)) : DampingVerdict();
    if (verdict.problem.empty()) return describe(problem, best, data, problems, verdict.note);
    of_damping = verdict.problem + "; it is fixed at 0";
    damping_free = false;
    valueOf(law, used.fixed, FitParameter::damping) = 0;
    shape_free = settings.free[index(FitParameter::shape)];
    of_shape.clear();
  }
}

}  // namespace fissure
