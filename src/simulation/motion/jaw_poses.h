#pragma once

#include <array>

#include "base/geometry.h"
#include "scenario/tools.h"

namespace fissure {

/// Poses of the left and the right jaw, in the scene frame, of a clamp at `pose`: each jaw is moved from its
/// place in the closed clamp by half the opening (metres, or degrees for hinged jaws). `closed`: the jaws as
/// closedJaws() returns them.
std::array<Pose, 2> jawPoses(const ClampSettings& clamp, const std::array<ClampPart, 2>& closed,
                             const Pose& pose, double opening);

}  // namespace fissure
