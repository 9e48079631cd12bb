#pragma once

#include <memory>
#include <string>

namespace fissure {

/// Force of one triangle at a deformation: magnitudes along the contact normal, newtons, >= 0 pushes apart.
struct LawForce {
  double elastic_N = 0;
  double viscous_N = 0;
  bool adhesion_clamped = false;  ///< the formula would have pulled: elastic + viscous were set to 0 together
};

/// F(x, x'): how hard tissue pushes back (METHOD: force). Never pulls. A law that is used per area gives N/m2
/// from coefficients per square metre.
class ForceLaw {
 public:
  virtual ~ForceLaw() = default;
  /// deformation_m >= 0; its rate in m/s, positive while it grows.
  virtual LawForce at(double deformation_m, double rate_m_s) const = 0;
};

/// F = k x^n + lambda x^n x' (Hunt and Crossley 1975; paper, section on the interaction force model).
/// k in N/m^n, lambda in N s/m^(n+1).
std::unique_ptr<ForceLaw> makeHuntCrossley(double k, double lambda, double n);

/// F = k x + c x', k in N/m, c in N s/m (METHOD: force).
std::unique_ptr<ForceLaw> makeKelvinVoigt(double k, double c);

/// F = k x, k in N/m: the default model that the paper replaced.
std::unique_ptr<ForceLaw> makeLinearElastic(double k);

/// Of all models; each reads those of its formula.
struct ForceCoefficients {
  double k = 0, lambda = 0, n = 1, c = 0;
};

/// The law of that name: "hunt_crossley", "kelvin_voigt", "linear_elastic". Throws std::invalid_argument for
/// another.
std::unique_ptr<ForceLaw> makeForceLaw(const std::string& model, const ForceCoefficients& coefficients);

}  // namespace fissure
