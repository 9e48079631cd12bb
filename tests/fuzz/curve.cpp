#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "fit/measured_curve.h"
#include "target.h"

namespace fissure::fuzz {

namespace {

void requireCurve(const MeasuredCurve& curve) {
  const std::size_t points = curve.force_N.size();
  require(points > 0 && curve.weights.size() == points, "a curve has points");
  for (const std::vector<double>* values :
       {&curve.depth_m, &curve.time_s, &curve.rate_m_s, &curve.rate_noise_m_s, &curve.lower_quartile_N})
    require(values->empty() || values->size() == points, "columns are as long as the curve");
  for (std::size_t i = 0; i < points; ++i) {
    require(std::isfinite(curve.force_N[i]) && curve.weights[i] > 0, "points have forces and weights");
    require(curve.depth_m.empty() || (curve.depth_m[i] >= 0 && std::isfinite(curve.depth_m[i])),
            "depths are >= 0");
  }
  require(std::is_sorted(curve.time_s.begin(), curve.time_s.end()), "times are in order");
  for (const std::string& warning : curve.warnings)
    require(isOneLine(warning), "a warning is one line: " + warning);
}

}  // namespace

/// Curves by the names of their columns, and by their places.
void takeCurve(const std::string& bytes) {
  const std::filesystem::path file = put("fuzzed.csv", bytes);
  for (const char* columns :
       {"", "depth=1:mm,force=2:mN", "time=1:ms,force=2:N,depth=3:-0.001,sigma=4:N,curve=5"}) {
    std::vector<MeasuredCurve> curves;
    const bool good = accepts(file, Refusal::file, [&] {
      curves = readCurves(file, *columns ? parseCurveColumns(columns) : std::vector<CurveColumn>());
    });
    if (!good) continue;
    for (const MeasuredCurve& curve : curves) requireCurve(curve);
    const MeasuredCurve all = joined(curves);  // the curves of a file are of one kind
    require(isOneLine(all.name), "joined curves have a name");
  }
}

}  // namespace fissure::fuzz
