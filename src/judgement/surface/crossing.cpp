#include "surface/crossing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fissure {

namespace {

/// A cubic on [0, 1] by its Bernstein coefficients: it lies between the smallest and the largest.
using Cubic = std::array<double, 4>;

struct Path {
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
};

/// A share of the step, from `enter` to `leave`.
struct Share {
  double enter = 0;
  double leave = 1;

  bool isEmpty() const { return enter > leave; }
  /// Leaves the part in which a value that goes straight from `before` to `now` is not negative.
  void keepWhereNotNegative(double before, double now) {
    if (before < 0 && now < 0) leave = -1;
    if (before < 0 && now >= 0) enter = std::max(enter, before / (before - now));
    if (before >= 0 && now < 0) leave = std::min(leave, before / (before - now));
  }
};

/// Six times the volume between triangle and point over the step: positive while the point is in front.
Cubic volumeOverStep(const TreeTriangle& before, const TreeTriangle& now, const Path& path) {
  const std::array<Vec3, 2> u{before.b - before.a, now.b - now.a};
  const std::array<Vec3, 2> v{before.c - before.a, now.c - now.a};
  const std::array<Vec3, 2> w{path.from - before.a, path.to - now.a};
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) { return u[i].cross(v[j]).dot(w[k]); };
  return {volume(0, 0, 0), (volume(1, 0, 0) + volume(0, 1, 0) + volume(0, 0, 1)) / 3,
          (volume(1, 1, 0) + volume(1, 0, 1) + volume(0, 1, 1)) / 3, volume(1, 1, 1)};
}

int signChanges(const Cubic& cubic) {
  int changes = 0;
  for (std::size_t i = 0; i < 3; ++i) changes += (cubic[i] > 0) != (cubic[i + 1] > 0);
  return changes;
}

struct Halves {
  Cubic left{};
  Cubic right{};
};

Halves split(const Cubic& c) {  // de Casteljau
  const double m01 = (c[0] + c[1]) / 2, m12 = (c[1] + c[2]) / 2, m23 = (c[2] + c[3]) / 2;
  const double m012 = (m01 + m12) / 2, m123 = (m12 + m23) / 2;
  const double middle = (m012 + m123) / 2;
  return {{c[0], m01, m012, middle}, {middle, m123, m23, c[3]}};
}

/// Calls `found(time, downwards)` at every change of sign (positive against not positive) within `share`, in
/// order of time; `start` and `length`: of the cubic's part of the step.
template <class Found>
void findSignChanges(const Cubic& cubic, double start, double length, const Share& share,
                     const Found& found) {
  const int changes = signChanges(cubic);
  if (changes == 0 || start > share.leave || start + length < share.enter) return;
  if (length < 1e-15) {
    if ((cubic[0] > 0) != (cubic[3] > 0)) found(start, cubic[0] > 0);
    return;
  }
  const Halves halves = split(cubic);
  findSignChanges(halves.left, start, length / 2, share, found);
  findSignChanges(halves.right, start + length / 2, length / 2, share, found);
}

/// Whether a point in the triangle's plane is in the triangle, with a slack that lets no path slip between
/// neighbours.
bool isInTriangle(const TreeTriangle& t, const Vec3& normal, const Vec3& point) {
  const double slack = -1e-9 * normal.squaredNorm();
  return normal.dot((t.b - t.a).cross(point - t.a)) >= slack &&
         normal.dot((t.c - t.b).cross(point - t.b)) >= slack &&
         normal.dot((t.a - t.c).cross(point - t.c)) >= slack;
}

TreeTriangle between(const TreeTriangle& before, const TreeTriangle& now, double time) {
  return {before.a + time * (now.a - before.a), before.b + time * (now.b - before.b),
          before.c + time * (now.c - before.c)};
}

/// Motion of the triangle's point that is met at `point`, over the step.
Vec3 motionAt(const TreeTriangle& before, const TreeTriangle& now, const TreeTriangle& met,
              const Vec3& normal, const Vec3& point) {
  const double area = normal.squaredNorm();
  const double at_b = normal.dot((met.a - met.c).cross(point - met.c)) / area;
  const double at_c = normal.dot((met.b - met.a).cross(point - met.a)) / area;
  return (1 - at_b - at_c) * (now.a - before.a) + at_b * (now.b - before.b) + at_c * (now.c - before.c);
}

/// Within `share` of the step.
void crossTriangle(const TreeTriangle& before, const TreeTriangle& now, const Path& path, const Share& share,
                   std::vector<Crossing>& crossings) {
  const Cubic volume = volumeOverStep(before, now, path);
  findSignChanges(volume, 0.0, 1.0, share, [&](double time, bool downwards) {
    const TreeTriangle met = between(before, now, time);
    const Vec3 normal = met.doubleAreaNormal();
    const Vec3 point = path.from + time * (path.to - path.from);
    if (normal.isZero(0.0) || !isInTriangle(met, normal, point)) return;
    crossings.push_back(
        {time, downwards, normal, path.to - path.from - motionAt(before, now, met, normal, point)});
  });
}

TreeBox boxOf(const TreeTriangle& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

/// When the point may be within `slack_m` of what moves straight from the one box into the other: it then
/// stays in a box whose sides go straight too. A box around all of the way would hold far more: tissue that
/// is thrown goes many times its triangles' size in a step.
Share meeting(const TreeBox& before, const TreeBox& now, const Path& path, double slack_m) {
  Share share;
  for (int axis = 0; axis < 3 && !share.isEmpty(); ++axis) {
    share.keepWhereNotNegative(path.from[axis] - before.low[axis] + slack_m,
                               path.to[axis] - now.low[axis] + slack_m);
    share.keepWhereNotNegative(before.high[axis] - path.from[axis] + slack_m,
                               now.high[axis] - path.to[axis] + slack_m);
  }
  return share;
}

/// As a share of the squared distances: the same for the sides of edges.
constexpr double kSideSlack = 1e-8;

/// Whether the point surely passes the triangle by. Seen along the way that they go against each other, it
/// would meet the triangle only where it is on the same side of all three edges; here it stays on opposite
/// sides of two of them, by more than rounding and the slack of isInTriangle.
bool passesBy(const TreeTriangle& before, const TreeTriangle& now, const Path& path) {
  const std::array<Vec3, 3> from{before.a - path.from, before.b - path.from, before.c - path.from};
  const std::array<Vec3, 3> to{now.a - path.to, now.b - path.to, now.c - path.to};
  const Vec3 way = (to[0] + to[1] + to[2] - from[0] - from[1] - from[2]) / 3;
  double farthest_m2 = 0;
  for (std::size_t i = 0; i < 3; ++i)
    farthest_m2 = std::max({farthest_m2, from[i].squaredNorm(), to[i].squaredNorm()});
  const double slack = kSideSlack * farthest_m2 * way.norm();
  bool left = false, right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    const double start = from[i].cross(from[k]).dot(way), end = to[i].cross(to[k]).dot(way);
    const double middle = (from[i].cross(to[k]) + to[i].cross(from[k])).dot(way) / 2;  // of Bernstein's three
    left |= std::min({start, middle, end}) > slack;
    right |= std::max({start, middle, end}) < -slack;
  }
  return left && right;
}

/// As a share of the extent of all that moves: more than rounding and the slack of isInTriangle.
constexpr double kBoxSlack = 1e-6;

}  // namespace

std::size_t findCrossings(const SurfaceTree& tree, const Vec3& from, const Vec3& to,
                          std::vector<Crossing>& crossings) {
  crossings.clear();
  const Path path{from, to};
  const TreeBox &before = tree.previousBoxes()[0], &now = tree.boxes()[0];
  const double slack_m =
      kBoxSlack * (before.high.cwiseMax(now.high) - before.low.cwiseMin(now.low)).maxCoeff();
  const std::size_t end = tree.nodes().size();
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < end;) {
    const TreeNode& node = tree.nodes()[i];
    if (meeting(tree.previousBoxes()[i], tree.boxes()[i], path, slack_m).isEmpty()) {
      i = static_cast<std::size_t>(node.skip);
      continue;
    }
    ++i;
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(node.first) + k;
      const TreeTriangle &earlier = tree.previous()[index], &later = tree.triangles()[index];
      const Share share = meeting(boxOf(earlier), boxOf(later), path, slack_m);
      if (share.isEmpty() || passesBy(earlier, later, path)) continue;
      crossTriangle(earlier, later, path, share, crossings);
      ++looked_at;
    }
  }
  // At the same time (a path through a sharp edge) leaving comes first: touching an edge is not passing
  // through.
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& one, const Crossing& other) {
    return std::pair(one.time, one.entering) < std::pair(other.time, other.entering);
  });
  return looked_at;
}

}  // namespace fissure
