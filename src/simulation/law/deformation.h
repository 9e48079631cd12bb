#pragma once

namespace fissure {

/// What a triangle's centroid is compared with (METHOD: force).
enum class DeformationKind {
  paper,      ///< with its place at rest: contains the motion of the body as a whole
  corotated,  ///< with its place at rest moved by the body's best-fit rigid motion
};

/// Where x' comes from.
enum class RateSource {
  differences,  ///< the centroid's way since the last step, over dt
  velocities,   ///< the engine's vertex velocities
};

}  // namespace fissure
