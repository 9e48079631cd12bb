#pragma once

namespace fissure {

/// What a triangle's centroid is compared with to get the deformation x (contact/METHOD.md 12).
enum class DeformationKind {
  paper,      ///< its position at rest: x contains rigid motion of the whole body
  corotated,  ///< its position at rest after the body's best-fit rigid motion
};

/// How the rate x' of a deformation is computed (contact/METHOD.md 12).
enum class RateSource {
  differences,  ///< displacement of the centroid since the last step, over dt
  velocities,   ///< from the engine's vertex velocities
};

}  // namespace fissure
