#pragma once

#include <optional>
#include <string>

namespace fissure {

/// One entry of `force:`: a force law evaluated in every step of every run.
///   hunt_crossley: F = k x^n + lambda x^n x'     kelvin_voigt: F = k x + c x'     linear_elastic: F = k x
/// x is taken for each triangle in a colliding state, and F summed over them. With `per_area` F is a
/// pressure, times the triangle's area at rest; the coefficients are then per square metre, and have no
/// default.
struct ForceSettings {
  std::string name;    ///< unique; default: the model's
  std::string model;   ///< a name in catalog().force_laws
  double k = 200;      ///< N/m^n, with per_area N/m^(n+2); n = 1 but for hunt_crossley; >= 0
  double lambda = 50;  ///< N s/m^(n+1), with per_area N s/m^(n+3), >= 0; hunt_crossley only
  double n = 1.3;      ///< exponent, > 0; hunt_crossley only
  /// Where x' comes from; not for linear_elastic. Response none leaves the engine's velocities of held tissue
  /// without meaning (tens of m/s at rest), so differences are the default.
  std::string rate = "differences";
  double c = 1;  ///< N s/m, with per_area N s/m^3, >= 0; kelvin_voigt only
  /// What a triangle is compared with. paper: its place at rest, so that the motion of the body as a whole
  /// counts as deformation; corotated: that place moved by the body's best-fit rotation and translation.
  std::string deformation = "paper";
  bool per_area =
      false;  ///< the total then converges as the mesh is refined; else it grows with the triangles
  /// A name in catalog().tissues: k, n and lambda where the file leaves them out (scenario/tissues.h says
  /// what they are worth); hunt_crossley without per_area only.
  std::optional<std::string> tissue;

  bool operator==(const ForceSettings&) const = default;
};

}  // namespace fissure
