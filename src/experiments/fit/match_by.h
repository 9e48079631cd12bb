#pragma once

namespace fissure {

/// Where a measured point and a simulation meet: at one time since the start, or at one depth, the way of the
/// tool until it is deepest.
enum class MatchBy { time, depth };

}  // namespace fissure
