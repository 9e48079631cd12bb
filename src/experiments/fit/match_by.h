#pragma once

namespace fissure {

/// The quantity by which measured and simulated points are matched: the time since the start, or the depth,
/// that is, the displacement of the tool until it is deepest.
enum class MatchBy { time, depth };

}  // namespace fissure
