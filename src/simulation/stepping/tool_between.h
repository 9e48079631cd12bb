#pragma once

#include "base/rotation.h"
#include "base/state.h"

namespace fissure {

/// The tool after the share `share` (0..1) of a step: its position is interpolated linearly, its orientation
/// by slerp; its velocities are those of `to`.
inline ToolState between(const ToolState& from, const ToolState& to, double share) {
  ToolState at = to;
  at.pose.position_m = from.pose.position_m + share * (to.pose.position_m - from.pose.position_m);
  at.pose.orientation = slerp(from.pose.orientation, share, to.pose.orientation);
  return at;
}

}  // namespace fissure
