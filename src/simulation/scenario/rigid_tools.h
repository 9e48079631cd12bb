#pragma once

#include <array>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace fissure {

/// The rigid tools of a scenario, in order: each clamp is replaced by its left and its right jaw, which have
/// the clamp's nodes, friction and force limit but no motion of their own (see jawPoses). Other tools are
/// unchanged.
std::vector<ToolSettings> rigidTools(const std::vector<ToolSettings>& tools);

/// Names of a clamp's left and right jaw: NAME_left, NAME_right.
std::array<std::string, 2> jawNames(const ToolSettings& clamp);

/// The left and right jaw of the closed clamp, with poses in the clamp's frame. A left jaw that is not given
/// is the mirror image of the right one in x = 0: its shape is then marked as mirrored in x = 0 of its own
/// frame.
std::array<ClampPart, 2> closedJaws(const ToolSettings& clamp);

}  // namespace fissure
