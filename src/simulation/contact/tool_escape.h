#pragma once

#include <span>

#include "base/geometry.h"
#include "contact/swept_obstacle.h"

namespace fissure {

/// The shortest displacement that frees a tool which overlaps tissue (contact/METHOD.md 10), among those
/// along the axes of the tool's frame and of the scene (`scene_axes`, columns in the tool's frame), longer by
/// a margin where there is room. In the tool's frame, metres; zero where the tool overlaps no tissue or no
/// displacement was found. `obstacles`: all of one tool, with the tissue at before_m.
Vec3 escapeOf(std::span<SweptObstacle> obstacles, const Mat3& scene_axes);

}  // namespace fissure
