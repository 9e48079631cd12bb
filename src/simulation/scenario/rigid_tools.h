#pragma once

#include <array>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace fissure {

/// The rigid tools that `tools` stand for, in their order: each clamp is replaced by its left and its right
/// jaw, which have the clamp's nodes, friction and limit, and no motion of their own (jawPoses). The others
/// are as they were.
std::vector<ToolSettings> rigidTools(const std::vector<ToolSettings>& tools);

/// Names of a clamp's left and right jaw: NAME_left, NAME_right.
std::array<std::string, 2> jawNames(const ToolSettings& clamp);

/// Where a closed clamp's left and right jaw are in its frame. The left one, unless it is given, is the
/// mirror image in x = 0; its shape is then the right one's mirror image in its own x = 0.
std::array<ClampPart, 2> closedJaws(const ToolSettings& clamp);

}  // namespace fissure
