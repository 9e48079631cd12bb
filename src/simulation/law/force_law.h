#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// The force laws, in the order of forceLaws().
enum class ForceModel { hunt_crossley, kelvin_voigt, linear_elastic, exponential };

/// Coefficients of all laws; a law reads only those of its own entry, which states their units: SI, and
/// additionally per square metre where the law is used per area.
struct LawCoefficients {
  double k = 0;       ///< factor of the elastic term
  double lambda = 0;  ///< factor of Hunt-Crossley's damping term
  double n = 1;       ///< exponent of the deformation
  double c = 0;       ///< factor of a damper parallel to the elastic term
  double a = 1;       ///< stiffening of an exponential law, 1/m

  bool operator==(const LawCoefficients&) const = default;
};

/// Force of one triangle (for a law per area: its pressure, N/m2): both terms along the contact normal,
/// positive where they push tool and tissue apart.
struct LawForce {
  double elastic_N = 0;
  double viscous_N = 0;
  bool adhesion_clamped = false;  ///< the formula would have pulled, so both terms were set to 0
};

/// Both terms of a law for coefficients of 1: F = k elastic + (damping coefficient) damping.
struct LawTerms {
  double elastic = 0;
  double damping = 0;
  double damping_over_elastic = 0;  ///< damping / elastic; may be infinite or NaN where elastic is 0
};

/// The role of a coefficient in its law.
enum class CoefficientRole {
  elastic,  ///< multiplies the elastic term
  damping,  ///< multiplies the damping term
  shape,    ///< determines how the elastic term grows with the deformation
};

/// One coefficient of one law.
struct LawCoefficient {
  std::string_view name;  ///< its name in scenarios, results, sweeps and fits
  double LawCoefficients::*member = nullptr;
  CoefficientRole role = CoefficientRole::elastic;
  double default_value = 0;  ///< default in scenarios without per_area
  /// Unit for people: "N/m^n"; "1" for a number without a unit.
  std::string_view unit;
  std::string_view units;           ///< unit in words, stored with results; empty for a number without a unit
  std::string_view units_per_area;  ///< the same for a law that is used per area
};

/// The range in which a fit searches for a law's shape coefficient.
struct ShapeSearch {
  double least = 0, largest = 0;
  std::array<double, 4> starts{};
  /// The numbers above are the coefficient times the typical deformation, and so without a unit.
  bool times_deformation = false;
};

/// One force law F(x, x') of the deformation x (m, >= 0) and its rate x' (m/s, positive while x grows); see
/// contact/METHOD.md 12. A law never pulls. All of the program's knowledge of a law is in its entry: keys of
/// scenarios and their defaults, help, attributes of results, axes of sweeps, many laws over one simulation,
/// fits.
struct ForceLawEntry {
  std::string_view name;         ///< in scenarios
  std::string_view description;  ///< one line for people, with the formula and its source
  std::string_view fit_formula;  ///< formula for people: F over the depth d of a probe, with the offset F0
  std::vector<LawCoefficient> coefficients;
  /// True: the damping term is the elastic term times the rate, so that damping coefficient / k is in s/m.
  /// False: it is the rate alone, and acts even at a deformation of 0.
  bool damping_grows_with_elastic = false;
  ShapeSearch shape_search;  ///< meaningful only for laws with a shape coefficient
  /// The force at a deformation in m and a rate in m/s.
  LawForce (*force)(const LawCoefficients& coefficients, double deformation_m, double rate_m_s) = nullptr;
  /// Its terms, for deformations > 0; equal to `force` but for rounding.
  LawTerms (*terms)(const LawCoefficients& coefficients, double deformation_m, double rate_m_s) = nullptr;

  /// The coefficient with this role, or of this name; null where the law has none.
  const LawCoefficient* find(CoefficientRole role) const;
  const LawCoefficient* find(std::string_view coefficient) const;
  /// The default values of the law's coefficients; those that it does not have keep their initial values.
  LawCoefficients defaults() const;
};

/// All laws, in the order of ForceModel.
const std::vector<ForceLawEntry>& forceLaws();
/// The entry of a law, and the law with this name; no value where there is none.
const ForceLawEntry& entryOf(ForceModel model);
std::optional<ForceModel> modelNamed(std::string_view name);

/// A coefficient that one or more laws have.
struct CoefficientName {
  std::string_view name;
  double LawCoefficients::*member = nullptr;
};

/// Every coefficient that at least one law has, each once, in the order of the laws.
const std::vector<CoefficientName>& allCoefficients();
/// The names of the laws that have a coefficient of this name, for messages: "model hunt_crossley", "models a
/// and b".
std::string modelsWith(std::string_view coefficient);
/// The same for laws that have a coefficient with this role.
std::string modelsWith(CoefficientRole role);

/// A law with values of its coefficients.
class ForceLaw {
 public:
  ForceLaw(ForceModel model, const LawCoefficients& coefficients)
      : entry_(&entryOf(model)), coefficients_(coefficients) {}

  /// The force in newtons, or in N/m2 where the coefficients are per area. deformation_m >= 0; rate_m_s is
  /// positive while the deformation grows.
  LawForce at(double deformation_m, double rate_m_s) const {
    return entry_->force(coefficients_, deformation_m, rate_m_s);
  }

 private:
  const ForceLawEntry* entry_;
  LawCoefficients coefficients_;
};

/// Both terms unchanged; zeros, marked as clamped, where their sum is negative.
inline LawForce withoutAdhesion(double elastic_N, double viscous_N) {
  if (elastic_N + viscous_N < 0) return {0, 0, true};
  return {elastic_N, viscous_N, false};
}

}  // namespace fissure
