#include "surface/continuous_collision.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace fissure {

namespace {

constexpr std::size_t kMostPoints = 4;
constexpr int kMostRefinements = 16;     // of a direction, for one hull
constexpr double kShortestPart = 1e-10;  // of a step
// Of the coordinates' size, which is at most 1 after scaling; u is half a unit in the last place, 1.1e-16. A
// coordinate carries the rounding of a difference of input, 1 u, and of an interpolation, 7 u; its share in a
// dot product with a direction of unit length 3 u more, and |x| + |y| + |z| of that direction is at most
// sqrt(3): 19 u for each piece, 38 u for both. The extreme points are chosen by such rounded values, twice;
// their difference, and its product with the direction, round again: less than 70 u = 7.8e-15 together.
constexpr double kRounding = 1e-14;

using Points = std::array<Vec3, kMostPoints>;

/// The points of one piece at both ends of a part of the step.
struct Piece {
  std::size_t count = 0;
  Points start, end;
};

/// The hull of all differences between points of two pieces during a part of the step.
struct DifferenceHull {
  Piece one, other;

  /// The point of the hull that is farthest against `direction`.
  Vec3 farthestAgainst(const Vec3& direction) const {
    const auto extreme = [&](const Points& low, std::size_t low_count, const Points& high,
                             std::size_t high_count, double& value) {
      std::size_t l = 0, h = 0;
      double least = low[0].dot(direction), most = high[0].dot(direction);
      for (std::size_t i = 1; i < low_count; ++i) {
        const double v = low[i].dot(direction);
        if (v < least) least = v, l = i;
      }
      for (std::size_t i = 1; i < high_count; ++i) {
        const double v = high[i].dot(direction);
        if (v > most) most = v, h = i;
      }
      value = least - most;
      return Vec3(low[l] - high[h]);
    };
    double at_start = 0, at_end = 0;
    const Vec3 start = extreme(one.start, one.count, other.start, other.count, at_start);
    const Vec3 end = extreme(one.end, one.count, other.end, other.count, at_end);
    return at_start <= at_end ? start : end;
  }

  /// The farthest any point moves against the first of `one`, which rests.
  double motion() const {
    double longest = 0;
    for (const Piece* piece : {&one, &other})
      for (std::size_t i = 0; i < piece->count; ++i)
        longest = std::max(longest, (piece->end[i] - piece->start[i]).cwiseAbs().maxCoeff());
    return longest;
  }
};

/// A simplex of at most four points; nearest() reduces it to the face nearest the origin.
class Simplex {
 public:
  bool contains(const Vec3& point) const {
    return std::find(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(count_), point) !=
           points_.begin() + static_cast<std::ptrdiff_t>(count_);
  }
  void add(const Vec3& point) { points_[count_++] = point; }

  /// The point nearest the origin; zero where the simplex holds it. Keeps the points of its face alone.
  Vec3 reduceToNearest() {
    if (count_ == 1) return points_[0];
    // Each subset whose affine hull's nearest point lies within it is a candidate: at most 15.
    double best = std::numeric_limits<double>::infinity();
    Vec3 nearest = points_[count_ - 1];
    unsigned best_set = 1U << (count_ - 1);
    for (unsigned set = 1; set < (1U << count_); ++set) {
      Vec3 point;
      if (!nearestOf(set, point)) continue;
      const double distance = point.squaredNorm();
      if (distance < best) best = distance, nearest = point, best_set = set;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if ((best_set >> i & 1U) != 0) points_[kept++] = points_[i];
    count_ = kept;
    return count_ == 4 ? Vec3(Vec3::Zero()) : nearest;
  }

 private:
  /// The point of the affine hull of a subset nearest the origin; false where it lies outside of the subset.
  bool nearestOf(unsigned set, Vec3& point) const {
    std::array<const Vec3*, 4> p{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if ((set >> i & 1U) != 0) p[n++] = &points_[i];
    if (n == 1) {
      point = *p[0];
      return true;
    }
    if (n == 2) {
      const Vec3 edge = *p[1] - *p[0];
      const double share = -p[0]->dot(edge) / edge.squaredNorm();
      point = *p[0] + share * edge;
      return share > 0 && share < 1;
    }
    if (n == 3) {
      const Vec3 normal = (*p[1] - *p[0]).cross(*p[2] - *p[0]);
      const double area = normal.squaredNorm();
      if (!(area > 0)) return false;
      for (std::size_t i = 0; i < 3; ++i)
        if (!(p[i]->cross(*p[(i + 1) % 3]).dot(normal) > 0)) return false;
      point = p[0]->dot(normal) / area * normal;
      return true;
    }
    const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)); };
    const std::array<double, 4> shares{volume(*p[1], *p[2], *p[3]), -volume(*p[0], *p[2], *p[3]),
                                       volume(*p[0], *p[1], *p[3]), -volume(*p[0], *p[1], *p[2])};
    point = Vec3::Zero();
    return std::all_of(shares.begin(), shares.end(), [](double s) { return s > 0; }) ||
           std::all_of(shares.begin(), shares.end(), [](double s) { return s < 0; });
  }

  std::array<Vec3, 4> points_;
  std::size_t count_ = 0;
};

/// Whether a plane keeps the hull farther than `margin` from the origin. The direction is found by the
/// algorithm of Gilbert, Johnson and Keerthi (1988), in floating point; the plane that it ends with is
/// proved.
bool hasSeparatingPlane(const DifferenceHull& hull, double margin, Vec3& direction, int& tests) {
  Simplex simplex;
  for (int i = 0; i < kMostRefinements; ++i) {
    ++tests;
    const Vec3 farthest = hull.farthestAgainst(direction);
    if (farthest.dot(direction) > margin) return true;
    if (simplex.contains(farthest)) return false;
    simplex.add(farthest);
    const Vec3 nearest = simplex.reduceToNearest();
    const double length = nearest.norm();
    if (!(length > 0)) return false;
    direction = nearest / length;
  }
  return false;
}

/// The paths of two pieces in the frame that moves with the first point of the one, scaled to a size of 1.
struct ScaledPaths {
  DifferenceHull whole;
  double scale = 0;  // metres a unit; not finite: coordinates are not
};

ScaledPaths scaledPaths(std::span<const MovingPoint> one, std::span<const MovingPoint> other) {
  ScaledPaths paths;
  double size = 0;
  bool finite = true;
  const auto take = [&](std::span<const MovingPoint> points, Piece& piece) {
    piece.count = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      piece.start[i] = points[i].start - one[0].start;
      piece.end[i] = points[i].end - one[0].end;
      finite = finite && piece.start[i].allFinite() && piece.end[i].allFinite();
      size = std::max({size, piece.start[i].cwiseAbs().maxCoeff(), piece.end[i].cwiseAbs().maxCoeff()});
    }
  };
  take(one, paths.whole.one);
  take(other, paths.whole.other);
  if (!finite) {
    paths.scale = std::numeric_limits<double>::infinity();
    return paths;
  }
  if (size == 0) return paths;
  // A power of two: scaling rounds nothing but what is far below 1. Sizes near the smallest doubles stay
  // below 1, and so nearer than rounding.
  int exponent = 0;
  std::frexp(size, &exponent);
  exponent = std::max(exponent, -1000);
  const double factor = std::ldexp(1.0, -exponent);
  for (Piece* piece : {&paths.whole.one, &paths.whole.other})
    for (std::size_t i = 0; i < piece->count; ++i) piece->start[i] *= factor, piece->end[i] *= factor;
  paths.scale = std::ldexp(1.0, exponent);
  return paths;
}

DifferenceHull partOf(const DifferenceHull& whole, double from, double to) {
  DifferenceHull part = whole;
  const auto cut = [&](const Piece& all, Piece& piece) {
    for (std::size_t i = 0; i < all.count; ++i) {
      const Vec3 motion = all.end[i] - all.start[i];
      piece.start[i] = all.start[i] + from * motion;
      piece.end[i] = all.start[i] + to * motion;
    }
  };
  cut(whole.one, part.one);
  cut(whole.other, part.other);
  return part;
}

}  // namespace

std::optional<double> earliestMeeting(std::span<const MovingPoint> one, std::span<const MovingPoint> other,
                                      double separation_m) {
  assert(!one.empty() && one.size() <= kMostPoints && !other.empty() && other.size() <= kMostPoints);
  const ScaledPaths paths = scaledPaths(one, other);
  if (!std::isfinite(paths.scale) || paths.scale == 0) return 0.0;
  const double margin = kRounding + separation_m / paths.scale;
  if (!(margin < 1)) return 0.0;

  int tests = 0;
  Vec3 direction = Vec3(paths.whole.one.start[0] - paths.whole.other.start[0]).normalized();
  if (!direction.allFinite() || direction.isZero(0.0)) direction = Vec3::UnitX();
  // Parts of the step that are still to be looked at, the earliest last.
  std::array<std::pair<double, double>, 64> parts;
  std::size_t count = 0;
  parts[count++] = {0.0, 1.0};
  while (count > 0) {
    const auto [from, to] = parts[--count];
    const DifferenceHull hull = from == 0 && to == 1 ? paths.whole : partOf(paths.whole, from, to);
    if (hasSeparatingPlane(hull, margin, direction, tests)) continue;
    const double middle = from + (to - from) / 2;
    if (to - from < kShortestPart || tests > kMostSeparationTests || hull.motion() < kRounding) return from;
    parts[count++] = {middle, to};
    parts[count++] = {from, middle};
  }
  return std::nullopt;
}

}  // namespace fissure
