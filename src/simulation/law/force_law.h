#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// The force laws, in the order of forceLaws().
enum class ForceModel { hunt_crossley, kelvin_voigt, linear_elastic, exponential };

/// Coefficients of all laws; each law reads those of its own entry and no others. Units are the entry's: SI,
/// and per square metre more for a law that is used per area.
struct LawCoefficients {
  double k = 0;       ///< size of the elastic term
  double lambda = 0;  ///< size of Hunt-Crossley's damping term
  double n = 1;       ///< exponent of the deformation
  double c = 0;       ///< of a damper beside the elastic term
  double a = 1;       ///< how fast an exponential law stiffens

  bool operator==(const LawCoefficients&) const = default;
};

/// Force of one triangle at a deformation: magnitudes along the contact normal, newtons, >= 0 pushes apart.
struct LawForce {
  double elastic_N = 0;
  double viscous_N = 0;
  bool adhesion_clamped = false;  ///< the formula would have pulled: elastic + viscous were set to 0 together
};

/// What both terms of a law are where their sizes are one: F = k elastic + (damping coefficient) damping.
struct LawTerms {
  double elastic = 0;
  double damping = 0;
  double damping_over_elastic = 0;  ///< the quotient; may be infinite or NaN where elastic is 0
};

/// What a coefficient does in its law.
enum class CoefficientRole {
  elastic,  ///< multiplies the elastic term
  damping,  ///< multiplies the damping term
  shape,    ///< says how the elastic term grows with the deformation
};

/// One coefficient of one law.
struct LawCoefficient {
  std::string_view name;  ///< in scenarios, results, sweeps and fits
  double LawCoefficients::*member = nullptr;
  CoefficientRole role = CoefficientRole::elastic;
  double default_value = 0;         ///< in scenarios, without per_area
  std::string_view unit;            ///< for people: "N/m^n"; "1" for a number
  std::string_view units;           ///< in words, stored with results; empty for a number
  std::string_view units_per_area;  ///< the same where the law is used per area
};

/// Where a fit looks for a law's shape coefficient.
struct ShapeSearch {
  double least = 0, largest = 0;
  std::array<double, 4> starts{};
  /// The numbers above are of the coefficient times the typical deformation, so that they have no unit.
  bool times_deformation = false;
};

/// One force law F(x, x'), x the deformation (m, >= 0) and x' its rate (m/s, positive while it grows). A law
/// never pulls. Everything that the program says and does about a law is read from its entry: keys of
/// scenarios and their defaults, help, attributes of results, axes of sweeps, many laws over one simulation,
/// fits.
struct ForceLawEntry {
  std::string_view name;         ///< in scenarios
  std::string_view description;  ///< one line for people, with the formula and its source
  std::string_view fit_formula;  ///< over the depth d of a probe, with the offset F0
  std::vector<LawCoefficient> coefficients;
  /// The damping term is the elastic term times the rate, so that damping coefficient / k is in s/m; else it
  /// is the rate alone, and acts where there is no deformation yet.
  bool damping_grows_with_elastic = false;
  ShapeSearch shape_search;  ///< of laws with a shape coefficient
  LawForce (*force)(const LawCoefficients& coefficients, double deformation_m, double rate_m_s) = nullptr;
  /// For deformations > 0. `force` and the terms agree but for rounding.
  LawTerms (*terms)(const LawCoefficients& coefficients, double deformation_m, double rate_m_s) = nullptr;

  /// Null where the law has none of this role, or of this name.
  const LawCoefficient* find(CoefficientRole role) const;
  const LawCoefficient* find(std::string_view coefficient) const;
  LawCoefficients defaults() const;
};

/// All laws, in the order of ForceModel.
const std::vector<ForceLawEntry>& forceLaws();
const ForceLawEntry& entryOf(ForceModel model);
std::optional<ForceModel> modelNamed(std::string_view name);

/// A coefficient without what single laws say of it.
struct CoefficientName {
  std::string_view name;
  double LawCoefficients::*member = nullptr;
};

/// Every coefficient that some law has, once, in the order of the laws.
const std::vector<CoefficientName>& allCoefficients();
/// The laws that have a coefficient of this name, for messages: "model hunt_crossley", "models a and b".
std::string modelsWith(std::string_view coefficient);
/// The same of laws that have one of this role.
std::string modelsWith(CoefficientRole role);

/// A law with its coefficients.
class ForceLaw {
 public:
  ForceLaw(ForceModel model, const LawCoefficients& coefficients)
      : entry_(&entryOf(model)), coefficients_(coefficients) {}

  /// deformation_m >= 0; rate_m_s positive while it grows. Per area the result is in N/m2.
  LawForce at(double deformation_m, double rate_m_s) const {
    return entry_->force(coefficients_, deformation_m, rate_m_s);
  }

 private:
  const ForceLawEntry* entry_;
  LawCoefficients coefficients_;
};

/// Both terms as they are; none where they would pull together.
inline LawForce withoutAdhesion(double elastic_N, double viscous_N) {
  if (elastic_N + viscous_N < 0) return {0, 0, true};
  return {elastic_N, viscous_N, false};
}

}  // namespace fissure
