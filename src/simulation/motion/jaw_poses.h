#pragma once

#include <array>

#include "base/geometry.h"
#include "scenario/tools.h"

namespace fissure {

/// Where the left and the right jaw of a clamp are in the scene: each half the opening (metres, or degrees of
/// hinged jaws) away from its place in the closed clamp, for a clamp at `pose`. `closed`: of closedJaws().
std::array<Pose, 2> jawPoses(const ClampSettings& clamp, const std::array<ClampPart, 2>& closed,
                             const Pose& pose, double opening);

}  // namespace fissure
