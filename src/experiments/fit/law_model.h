#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "fit/measured_curve.h"
#include "law/force_law.h"

namespace fissure {

/// A law with what a fit adds to it: F0, the force where the depth begins, which may pull.
struct FitValues {
  LawCoefficients coefficients;
  double F0_N = 0;
};

/// What a fit may search: a law's coefficients by what they do in it, and F0.
enum class FitParameter { elastic, damping, shape, offset };
inline constexpr std::array kFitParameters = {FitParameter::elastic, FitParameter::damping,
                                              FitParameter::shape, FitParameter::offset};

/// Whether the law has such a coefficient at all.
bool hasParameter(ForceModel law, FitParameter parameter);
/// Its name in this law: "k", "lambda", "c", "n", "F0". Throws std::invalid_argument where it has none, as
/// the next two do.
std::string nameOf(ForceModel law, FitParameter parameter);
/// Its unit: "N/m^n", ...
std::string unitOf(ForceModel law, FitParameter parameter);
double& valueOf(ForceModel law, FitValues& values, FitParameter parameter);
double valueOf(ForceModel law, const FitValues& values, FitParameter parameter);
constexpr std::size_t index(FitParameter parameter) {
  return static_cast<std::size_t>(parameter);
}

/// What a law gives at the points of a measurement, as a function of its coefficients.
class LawModel {
 public:
  virtual ~LawModel() = default;
  virtual ForceModel law() const = 0;
  virtual std::size_t size() const = 0;
  /// The law's forces without F0, newtons: size() of them.
  virtual void evaluate(const FitValues& values, std::span<double> force_N) const = 0;
  /// What noise of the rates makes of these forces: standard deviations, newtons. 0 where rates have none.
  virtual void evaluateNoise(const FitValues& values, std::span<double> noise_N) const;
  /// How large deformations and their rates are, roughly: > 0; rates may be 0 throughout.
  virtual double deformationScale_m() const = 0;
  virtual double rateScale_m_s() const = 0;
};

/// The law of a whole probe at the measured depths, and rates where there are times. Copies what it needs of
/// the curve. Throws InputError, without a file, where it has no depth above 0.
std::unique_ptr<LawModel> makeProbeModel(ForceModel law, const MeasuredCurve& curve);

}  // namespace fissure
