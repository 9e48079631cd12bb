#pragma once

#include <optional>
#include <span>

#include "base/geometry.h"

namespace fissure {

/// A point on a straight path at constant velocity during a step, metres, any frame.
struct MovingPoint {
  Vec3 start = Vec3::Zero();
  Vec3 end = Vec3::Zero();
};

/// Conservative continuous collision detection between two moving convex pieces (measure/METHOD.md 3), each
/// the convex hull of one to four moving points: vertex against triangle (1 and 3 points), edge against edge
/// (2 and 2), triangle against triangle (3 and 3).
///
/// No value: it is proved that the pieces stay farther apart than `separation_m` (>= 0) throughout the step.
/// A value in [0, 1]: they are proved farther apart before that share of the step; then they may meet. No
/// meeting is missed, whatever the rounding: each part of the step that is left out has a separating plane
/// whose margin exceeds a bound of all rounding errors. What cannot be proved apart counts as a meeting:
/// pieces nearer than about 1e-14 of their size and relative motion, parts of the step below 1e-10 of it,
/// pairs that need more than kMostSeparationTests planes, and coordinates that are not finite.
///
/// At any time the differences between the points of the two pieces span the pieces' Minkowski difference.
/// Between two times every such difference lies in the convex hull of the differences at both, because paths
/// are straight. The step is halved until each of these hulls excludes the origin.
std::optional<double> earliestMeeting(std::span<const MovingPoint> one, std::span<const MovingPoint> other,
                                      double separation_m = 0);

/// Planes that earliestMeeting tries before it gives up.
inline constexpr int kMostSeparationTests = 2000;

}  // namespace fissure
