#pragma once

#include "base/state.h"

namespace fissure {

/// The tool `share` of its way from one pose to the next, at their velocity.
inline ToolState between(const ToolState& from, const ToolState& to, double share) {
  ToolState at = to;
  at.pose.position_m = from.pose.position_m + share * (to.pose.position_m - from.pose.position_m);
  at.pose.orientation = from.pose.orientation.slerp(share, to.pose.orientation);
  return at;
}

}  // namespace fissure
