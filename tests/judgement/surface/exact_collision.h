#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <span>

#include "surface/continuous_collision.h"

namespace fissure::test {

/// What integer arithmetic without rounding says of two moving primitives.
enum class Meeting {
  never,     ///< they stay apart throughout the step
  certain,   ///< they meet: their volume changes its sign within both, or is 0 at a dyadic time within both
  undecided  ///< neither is shown: they stay in one plane, or graze at a time that no halving of the step
             ///< hits
};

/// Exact coordinates: integers small enough for 128 bits (below 2^9), or any.
using SmallInteger = __int128;
using BigInteger = boost::multiprecision::cpp_int;

/// Vertex against triangle (1 and 3 points) or edge against edge (2 and 2); integral coordinates below 2^9.
Meeting exactMeeting(std::span<const MovingPoint> one, std::span<const MovingPoint> other);

/// The same for any doubles, at whatever cost.
Meeting exactMeetingOfDoubles(std::span<const MovingPoint> one, std::span<const MovingPoint> other);

/// Whether two pieces share a point at `time`: the shares of their points (summing up to 1) are a witness.
/// All in rational numbers.
bool isWitness(std::span<const MovingPoint> one, std::span<const MovingPoint> other, double time,
               std::span<const double> shares_of_one, std::span<const double> shares_of_other);

}  // namespace fissure::test
