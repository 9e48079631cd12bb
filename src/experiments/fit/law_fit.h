#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fit/law_model.h"

namespace fissure {

struct FitSettings {
  FitValues fixed;                                 ///< of what is not free
  std::array<bool, kFitParameters.size()> free{};  ///< by FitParameter; only what the law has
};

/// One coefficient of a fit.
struct FittedValue {
  double value = 0;
  bool free = false;
  // Of free ones; NaN where the data says nothing.
  double standard_error = 0;  ///< from J'J at the optimum
  double low = 0, high = 0;   ///< 95 % interval; infinite, for k and the shape a limit, where it is open
  bool profiled = false;      ///< its ends are the profile's
  std::string problem;        ///< why it cannot be identified; also of a damping that was fixed for that
};

struct LawFit {
  ForceModel model = ForceModel::hunt_crossley;
  std::array<FittedValue, kFitParameters.size()> values;  ///< by FitParameter
  /// Correlation of each pair of free coefficients, k by its logarithm; NaN where one of them is not free.
  std::array<std::array<double, kFitParameters.size()>, kFitParameters.size()> correlation{};
  /// lambda/k and half its 95 % interval, s/m, by the standard error; NaN but where both are fitted, and of
  /// laws whose damping does not grow with their elastic force.
  double lambda_over_k_s_m = 0, lambda_over_k_half_width_s_m = 0;
  std::size_t points = 0;
  int free_count = 0;
  double rms_N = 0;                 ///< root of the (weighted) mean square of the residuals
  double r_squared = 0;             ///< 1 - their sum of squares over that around the (weighted) mean force
  double singular_value_ratio = 0;  ///< least over largest, of the Jacobian with columns of length one
  double next_correlation = 0;      ///< of residuals with the next one's
  bool converged = false;
  std::vector<std::string> notes;  ///< what a reader must know

  const FittedValue& of(FitParameter parameter) const { return values[index(parameter)]; }
  FitValues law() const;
};

/// Least squares over log k, the damping over k, the shape between its law's limits and F0 by Levenberg and
/// Marquardt's method, from four shapes. Weights are relative: the size of the error is taken from the
/// residuals.
///
/// 95 % intervals: value -+ t(points - free) standard errors; of k by its logarithm. Where the residuals do
/// not agree with that at one of its ends, by more than a tenth of t, its ends are the profile's: with the
/// rest fitted anew the sum of squares has grown by t^2 s^2 there (Bates and Watts 1988, section 6.1).
///
/// The damping (lambda of Hunt-Crossley, c of a damper) cannot be identified without rates; where k and it do
/// the same, as at one rate throughout (a singular value ratio below 1e-7); where noise of the depths makes
/// more than a tenth of what tells it (FitIntervals::rateReliability); and where the 95 % interval of
/// damping over k holds 0 and is wider than +-0.1 s/m, a tenth of the elastic force at 1 m/s (of a damper:
/// over the elastic term at the typical depth). It is then fixed at 0 and the rest fitted again. A note says
/// where that interval leaves out 0, but is wider than half the value to either side, and where it lies below
/// 0.
///
/// Also said: where a constant force fits as well, if F0 is free (F test, 5 %); where an interval of
/// the shape reaches a limit; and where residuals of neighbouring points correlate by more than 0.2 and than
/// chance would have it once in a hundred times (2.33 / sqrt(points), from 20 points on).
///
/// Throws InputError, one line without a file, where nothing can be fitted: too few points, one force, one
/// depth, no free coefficient.
LawFit fitLaw(const LawModel& model, std::span<const double> force_N, std::span<const double> weights,
              const FitSettings& settings);

}  // namespace fissure
