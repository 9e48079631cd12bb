#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "fit/measured_curve.h"

namespace fissure {

/// hunt_crossley: F = F0 + k d^n + lambda d^n d'   kelvin_voigt: F0 + k d + lambda d'   linear_elastic: F0 +
/// k d
enum class FitLaw { hunt_crossley, kelvin_voigt, linear_elastic };

/// Coefficients in N, m and s. The law's part never pulls; F0, the force where the depth begins, may.
struct LawValues {
  double k = 0;
  double lambda = 0;
  double n = 1;
  double F0_N = 0;
};

enum class FitParameter { k, lambda, n, F0 };
inline constexpr std::size_t kFitParameters = 4;

/// A name in catalog().force_laws.
std::string nameOf(FitLaw law);
/// "k", "lambda", "n", "F0".
std::string nameOf(FitParameter parameter);
/// Unit of a law's coefficient: "N/m^n", ...
std::string unitOf(FitLaw law, FitParameter parameter);
/// Whether the law has such a coefficient at all.
bool hasParameter(FitLaw law, FitParameter parameter);
double& valueOf(LawValues& values, FitParameter parameter);
double valueOf(const LawValues& values, FitParameter parameter);

/// What a law gives at the points of a measurement, as a function of its coefficients.
class LawModel {
 public:
  virtual ~LawModel() = default;
  virtual FitLaw law() const = 0;
  virtual std::size_t size() const = 0;
  /// The law's forces without F0, newtons: size() of them.
  virtual void evaluate(const LawValues& values, std::span<double> force_N) const = 0;
  /// What noise of the rates makes of these forces: standard deviations, newtons. 0 where rates have none.
  virtual void evaluateNoise(const LawValues& values, std::span<double> noise_N) const;
  /// How large deformations and their rates are, roughly: > 0; rates may be 0 throughout.
  virtual double deformationScale_m() const = 0;
  virtual double rateScale_m_s() const = 0;
};

/// The law of a whole probe at the measured depths, and rates where there are times. Copies what it needs of
/// the curve. Throws InputError, without a file, where it has no depth above 0.
std::unique_ptr<LawModel> makeProbeModel(FitLaw law, const MeasuredCurve& curve);

}  // namespace fissure
