#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fit/law_model.h"

namespace fissure {

/// The free and the fixed parameters of a fit.
struct FitSettings {
  FitValues fixed;                                 ///< values of parameters that are not free
  std::array<bool, kFitParameters.size()> free{};  ///< [FitParameter] only parameters that the law has
};

/// One parameter of a fit.
struct FittedValue {
  double value = 0;
  bool free = false;
  // Of free ones; NaN where the data says nothing.
  double standard_error = 0;  ///< from (J'J)^-1 at the optimum
  double low = 0, high = 0;   ///< 95 % interval; an open end is infinite, for k and the shape its limit
  bool profiled = false;      ///< the ends of the interval come from profiling
  std::string problem;        ///< why it cannot be identified, or why a damping was fixed
};

/// The fit of a force law to a measured curve.
struct LawFit {
  ForceModel model = ForceModel::hunt_crossley;
  std::array<FittedValue, kFitParameters.size()> values;  ///< [FitParameter]
  /// Correlations of the free parameters, with log k for k; NaN where one of the two is not free.
  std::array<std::array<double, kFitParameters.size()>, kFitParameters.size()> correlation{};
  /// lambda/k and half its 95 % interval, from the standard error. NaN unless both are fitted, and for laws
  /// whose damping does not grow with their elastic force.
  double lambda_over_k_s_m = 0, lambda_over_k_half_width_s_m = 0;
  std::size_t points = 0;
  int free_count = 0;
  double rms_N = 0;  ///< root of the (weighted) mean square of the residuals
  /// 1 - sum of squared residuals over that of deviations from the (weighted) mean force.
  double r_squared = 0;
  double singular_value_ratio = 0;  ///< FitIntervals::singularValueRatio()
  double next_correlation = 0;      ///< correlation of neighbouring residuals
  bool converged = false;
  std::vector<std::string> notes;  ///< remarks for people

  const FittedValue& of(FitParameter parameter) const { return values[index(parameter)]; }
  FitValues law() const;
};

/// Fits a law by weighted least squares over log k, the damping over k, the shape between its limits and F0,
/// by Levenberg and Marquardt's method from four initial shapes. Weights are relative: the error variance is
/// estimated from the residuals.
///
/// 95 % intervals are value -+ t(points - free) standard errors, for k on a logarithmic scale. Where the
/// residuals at one of the ends contradict this by more than a tenth of t, the interval is that of the
/// profile: at its ends the sum of squares, with all other parameters fitted again, has grown by t^2 s^2
/// (Bates and Watts 1988, section 6.1).
///
/// The damping (lambda of Hunt-Crossley, c of a damper) cannot be identified without rates; where it has the
/// same effect as k, as at a constant rate (singular value ratio below 1e-7); where noise of the depths
/// accounts for more than a tenth of its evidence (FitIntervals::rateReliability); and where the 95 %
/// interval of damping over k contains 0 and is wider than +-0.1 s/m, a tenth of the elastic force at 1 m/s
/// (for a damper: over the elastic term at the typical depth). It is then fixed at 0 and the rest is fitted
/// again. Notes tell where that interval excludes 0 but is wider than half the value to either side, and
/// where it lies below 0.
///
/// Further notes tell where a constant force fits as well, if F0 is free (F test, 5 %); where the interval of
/// the shape reaches a limit; and where residuals of neighbouring points have a correlation above 0.2 and
/// above the 1 % level of chance (2.33 / sqrt(points), from 20 points on).
///
/// Throws InputError, one line without a file, where nothing can be fitted: too few points, one force, one
/// depth, no free coefficient.
LawFit fitLaw(const LawModel& model, std::span<const double> force_N, std::span<const double> weights,
              const FitSettings& settings);

}  // namespace fissure
