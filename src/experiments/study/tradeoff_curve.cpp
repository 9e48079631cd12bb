#include "study/tradeoff_curve.h"

#include <algorithm>
#include <cmath>

#include "measure/statistics.h"

namespace fissure {

namespace {

/// Two times count as the same where they differ by at most this share of a step.
constexpr double curve_slack = 1e-6;

/// The mean step; 0 where there is none.
double meanStep_s(const StudyCurve& curve) {
  if (curve.time_s.size() < 2) return 0;
  return (curve.time_s.back() - curve.time_s.front()) / static_cast<double>(curve.time_s.size() - 1);
}

}  // namespace

double StudyCurve::peak() const {
  double most = values.empty() ? kMissing : 0;
  for (const double value : values) {
    if (std::isnan(value)) return kMissing;
    most = std::max(most, std::abs(value));
  }
  return most;
}

double valueAt(const StudyCurve& curve, double time_s) {
  if (curve.empty() || std::isnan(time_s)) return kMissing;
  const double near_s = curve_slack * meanStep_s(curve);
  if (time_s < curve.time_s.front() - near_s || time_s > curve.time_s.back() + near_s) return kMissing;
  const auto after = std::lower_bound(curve.time_s.begin(), curve.time_s.end(), time_s);
  const auto at = static_cast<std::size_t>(after - curve.time_s.begin());
  if (at == curve.time_s.size()) return curve.values.back();
  if (at == 0 || curve.time_s[at] - time_s <= near_s) return curve.values[at];
  if (time_s - curve.time_s[at - 1] <= near_s) return curve.values[at - 1];
  const double share = (time_s - curve.time_s[at - 1]) / (curve.time_s[at] - curve.time_s[at - 1]);
  return (1 - share) * curve.values[at - 1] + share * curve.values[at];
}

CurveError errorOf(const StudyCurve& run, const StudyCurve& reference) {
  if (run.empty() || reference.empty()) return {};
  const StudyCurve& coarse = run.time_s.size() < reference.time_s.size() ? run : reference;
  const double step_s = std::max(meanStep_s(run), meanStep_s(reference)) * (1 + curve_slack);
  if (std::abs(run.time_s.back() - reference.time_s.back()) > step_s ||
      std::abs(run.time_s.front() - reference.time_s.front()) > step_s)
    return {};
  const double first_s = std::max(run.time_s.front(), reference.time_s.front()) - curve_slack * step_s;
  const double last_s = std::min(run.time_s.back(), reference.time_s.back()) + curve_slack * step_s;
  CurveError error{0, 0, 0};
  double count = 0, run_peak = 0, reference_peak = 0;
  for (const double time_s : coarse.time_s) {
    if (time_s < first_s || time_s > last_s) continue;
    const double of_run = valueAt(run, time_s), of_reference = valueAt(reference, time_s);
    const double difference = std::abs(of_run - of_reference);
    if (!std::isfinite(difference)) return {};
    error.rms += difference * difference;
    error.worst = std::max(error.worst, difference);
    run_peak = std::max(run_peak, std::abs(of_run));
    reference_peak = std::max(reference_peak, std::abs(of_reference));
    ++count;
  }
  if (count == 0) return {};
  error.rms = std::sqrt(error.rms / count);
  error.peak = std::abs(run_peak - reference_peak);
  return error;
}

}  // namespace fissure
