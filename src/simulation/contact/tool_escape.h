#pragma once

#include <span>

#include "base/geometry.h"
#include "contact/swept_obstacle.h"

namespace fissure {

/// The shortest way, among those along the axes of the tool's frame and of `scene_axes` (the scene's in the
/// tool's frame), on which a tool that overlaps tissue leaves it, and a margin more where there is room; in
/// the tool's frame, zero where it overlaps none or leaves it nowhere. `obstacles`: those of one tool, with
/// the tissue at before_m.
Vec3 escapeOf(std::span<SweptObstacle> obstacles, const Mat3& scene_axes);

}  // namespace fissure
