#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "fit/measured_curve.h"
#include "law/force_law.h"

namespace fissure {

/// The values of all parameters of a fit: the law's coefficients, and F0, the force at depth 0, which may be
/// negative.
struct FitValues {
  LawCoefficients coefficients;
  double F0_N = 0;
};

/// A parameter of a fit: one of a law's coefficients, by its role, or F0.
enum class FitParameter { elastic, damping, shape, offset };
inline constexpr std::array kFitParameters = {FitParameter::elastic, FitParameter::damping,
                                              FitParameter::shape, FitParameter::offset};

/// Whether the law has such a parameter.
bool hasParameter(ForceModel law, FitParameter parameter);
/// The name of a parameter in this law: "k", "lambda", "c", "n", "F0". Throws std::invalid_argument where the
/// law has none, as do the functions below.
std::string nameOf(ForceModel law, FitParameter parameter);
/// The unit of a parameter in this law: "N/m^n" ...
std::string unitOf(ForceModel law, FitParameter parameter);
double& valueOf(ForceModel law, FitValues& values, FitParameter parameter);
double valueOf(ForceModel law, const FitValues& values, FitParameter parameter);
constexpr std::size_t index(FitParameter parameter) {
  return static_cast<std::size_t>(parameter);
}

/// The forces of a law at the points of a measurement, as a function of its coefficients.
class LawModel {
 public:
  virtual ~LawModel() = default;
  virtual ForceModel law() const = 0;
  virtual std::size_t size() const = 0;
  /// Computes the law's forces without F0 at all points, newtons; force_N has size() elements.
  virtual void evaluate(const FitValues& values, std::span<double> force_N) const = 0;
  /// Computes the standard deviations of these forces that follow from noise of the rates, newtons; 0 without
  /// noise.
  virtual void evaluateNoise(const FitValues& values, std::span<double> noise_N) const;
  /// Typical size of the deformations (> 0) and of their rates (0 where all rates are 0).
  virtual double deformationScale_m() const = 0;
  virtual double rateScale_m_s() const = 0;
};

/// A law for a whole probe at the measured depths, and at the measured rates where the curve has times. The
/// curve is copied. Throws InputError, without a file, where no depth is above 0.
std::unique_ptr<LawModel> makeProbeModel(ForceModel law, const MeasuredCurve& curve);

}  // namespace fissure
