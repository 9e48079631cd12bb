#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "fit/measured_curve.h"
#include "fit/press_curve.h"

namespace fissure {

/// What F = E/E0 f(d + d0) + F0 has, f being the simulated force at E0.
enum class ModulusParameter { modulus, force_offset, depth_offset };
inline constexpr std::array kModulusParameters = {ModulusParameter::modulus, ModulusParameter::force_offset,
                                                  ModulusParameter::depth_offset};
constexpr std::size_t index(ModulusParameter parameter) {
  return static_cast<std::size_t>(parameter);
}
std::string nameOf(ModulusParameter parameter);  ///< "E", "F0", "d0"
std::string unitOf(ModulusParameter parameter);  ///< "Pa", "N", "m"

struct ModulusSettings {
  std::array<bool, 3> free = {true, true, false};  ///< by ModulusParameter
  /// Values of the parameters that are not free, in their units; a fixed modulus must be > 0.
  std::array<double, 3> fixed = {0, 0, 0};
  /// Points deeper than this are not fitted but predicted.
  double most_depth_m = std::numeric_limits<double>::infinity();
};

struct ModulusValue {
  double value = 0;
  bool free = false;
  /// Where it is free: its standard error from the Jacobian, and its 95 % interval by profiling. An open end
  /// is infinite, the lower end of E then 0.
  double standard_error = 0, low = 0, high = 0;
};

/// A measured point beyond those fitted.
struct ModulusPrediction {
  double depth_m = 0, measured_N = 0;
  double predicted_N = 0, low_N = 0, high_N = 0;      ///< with the 95 % interval of the fitted curve there
  double lower_quartile_N = 0, upper_quartile_N = 0;  ///< measured; NaN: not in the file
};

struct ModulusFit {
  std::array<ModulusValue, 3> values;                  ///< by ModulusParameter
  std::array<std::array<double, 3>, 3> correlation{};  ///< of free ones, E by its logarithm
  std::size_t points = 0;                              ///< fitted
  double rms_N = 0, r_squared = 0;                     ///< as LawFit's, of the fitted points
  bool converged = false;
  std::vector<ModulusPrediction> predictions;  ///< deepest last, as far as the simulation reaches
  std::vector<std::string> notes;              ///< what a reader must know, one line each

  const ModulusValue& of(ModulusParameter parameter) const { return values[index(parameter)]; }
};

/// Weighted least squares over log E and the offsets. Weights are relative: the size of the error is taken
/// from the residuals. 95 % intervals are the profile's: with the rest fitted anew the sum of squares has
/// grown by t^2 s^2 at their ends (as fitLaw()), which for E and F0 are those of the linear problem. That of
/// d0 ends where the simulation does.
///
/// Notes say what the points do not tell: an interval of E wider than a factor of 2, E and an offset that do
/// nearly the same (correlation beyond 0.95), points below the deepest that are not predicted.
///
/// Throws InputError, one line without a file, where there is no depth, a fitted point (moved by d0) is
/// deeper than the simulation, there are no more points than free parameters, or the free ones do the same.
ModulusFit fitModulus(const PressCurve& press, const MeasuredCurve& curve, const ModulusSettings& settings);

}  // namespace fissure
