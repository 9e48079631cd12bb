#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "fit/measured_curve.h"
#include "fit/press_curve.h"

namespace fissure {

/// A parameter of F = E/E0 f(d + d0) + F0, where f is the force simulated with the modulus E0 and d the
/// depth.
enum class ModulusParameter { modulus, force_offset, depth_offset };
inline constexpr std::array kModulusParameters = {ModulusParameter::modulus, ModulusParameter::force_offset,
                                                  ModulusParameter::depth_offset};
constexpr std::size_t index(ModulusParameter parameter) {
  return static_cast<std::size_t>(parameter);
}
/// "E", "F0", "d0".
std::string nameOf(ModulusParameter parameter);
/// "Pa", "N", "m".
std::string unitOf(ModulusParameter parameter);

/// Settings of the fit of a modulus.
struct ModulusSettings {
  std::array<bool, 3> free = {true, true, false};  ///< [ModulusParameter]
  /// Values of the parameters that are not free, in their units; a fixed modulus must be > 0.
  std::array<double, 3> fixed = {0, 0, 0};
  /// Points deeper than this are not fitted but predicted.
  double most_depth_m = std::numeric_limits<double>::infinity();
};

/// The value of a parameter.
struct ModulusValue {
  double value = 0;
  bool free = false;
  /// For a free parameter: standard error from the Jacobian, and 95 % interval by profiling. An open end is
  /// infinite, or 0 for the lower end of E.
  double standard_error = 0, low = 0, high = 0;
};

/// The prediction for a measured point beyond the fitted ones.
struct ModulusPrediction {
  double depth_m = 0, measured_N = 0;
  /// Predicted force, with the 95 % interval of the fitted curve.
  double predicted_N = 0, low_N = 0, high_N = 0;
  double lower_quartile_N = 0, upper_quartile_N = 0;  ///< measured quartiles; NaN: not in the file
};

/// The fit of a modulus to a measured curve.
struct ModulusFit {
  std::array<ModulusValue, 3> values;                  ///< [ModulusParameter]
  std::array<std::array<double, 3>, 3> correlation{};  ///< of free parameters, with log E for E
  std::size_t points = 0;                              ///< number of fitted points
  double rms_N = 0, r_squared = 0;                     ///< as in LawFit, over the fitted points
  bool converged = false;
  std::vector<ModulusPrediction> predictions;  ///< in the order of depth, as far as the simulation reaches
  std::vector<std::string> notes;              ///< remarks for people, one line each

  const ModulusValue& of(ModulusParameter parameter) const { return values[index(parameter)]; }
};

/// Fits a modulus by weighted least squares over log E and the offsets. Weights are relative: the error
/// variance is estimated from the residuals. 95 % intervals come from profiling: at their ends the sum of
/// squares, with all other parameters fitted again, has grown by t^2 s^2 (as in fitLaw). For E and F0 these
/// are the intervals of the linear problem. The interval of d0 ends where the simulation does.
///
/// Notes tell where the data are insufficient: an interval of E wider than a factor of 2, E and an offset
/// with nearly the same effect (correlation beyond 0.95), points that are too deep to be predicted.
///
/// Throws InputError, one line without a file, where the curve has no depths, a fitted point (moved by d0) is
/// deeper than the simulation, there are not more points than free parameters, or free parameters have the
/// same effect.
ModulusFit fitModulus(const PressCurve& press, const MeasuredCurve& curve, const ModulusSettings& settings);

}  // namespace fissure
