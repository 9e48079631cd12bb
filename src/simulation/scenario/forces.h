#pragma once

#include <optional>
#include <string>

#include "law/deformation.h"
#include "law/force_law.h"

namespace fissure {

/// One entry of `force:`: a force law evaluated in every step of every run.
/// x is taken for each triangle in a colliding state, and F(x, x') summed over them. With `per_area` F is a
/// pressure, times the triangle's area at rest; the sizes of the law's terms are then per square metre, and
/// have no default.
struct ForceSettings {
  std::string name;  ///< unique; default: the model's
  ForceModel model = ForceModel::hunt_crossley;
  /// Sizes of terms >= 0, shapes > 0; those that the law does not have keep their neutral values. The
  /// defaults are of the model that is named with them: whoever changes it later sets them too.
  LawCoefficients coefficients = entryOf(model).defaults();
  /// Where x' comes from; of laws with a damping term. Response none leaves the engine's velocities of held
  /// tissue without meaning (tens of m/s at rest), so differences are the default.
  RateSource rate = RateSource::differences;
  /// What a triangle is compared with. paper: its place at rest, so that the motion of the body as a whole
  /// counts as deformation; corotated: that place moved by the body's best-fit rotation and translation.
  DeformationKind deformation = DeformationKind::paper;
  bool per_area =
      false;  ///< the total then converges as the mesh is refined; else it grows with the triangles
  /// A name in catalog().tissues: k, n and lambda where the file leaves them out (scenario/tissues.h says
  /// what they are worth); hunt_crossley without per_area only.
  std::optional<std::string> tissue;

  bool operator==(const ForceSettings&) const = default;
};

}  // namespace fissure
