#include "measure/crossing.h"

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
  Vec3 inverse = Vec3::Zero();  // of to - from; infinite along axes without motion
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

/// Calls `found(time, downwards)` at every change of sign (positive against not positive), in order of time.
template <class Found>
void findSignChanges(const Cubic& cubic, double start, double length, const Found& found) {
  const int changes = signChanges(cubic);
  if (changes == 0) return;
  if (length < 1e-15) {
    if ((cubic[0] > 0) != (cubic[3] > 0)) found(start, cubic[0] > 0);
    return;
  }
  const Halves halves = split(cubic);
  findSignChanges(halves.left, start, length / 2, found);
  findSignChanges(halves.right, start + length / 2, length / 2, found);
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

void crossTriangle(const TreeTriangle& before, const TreeTriangle& now, const Path& path,
                   std::vector<Crossing>& crossings) {
  const Cubic volume = volumeOverStep(before, now, path);
  if (signChanges(volume) == 0) return;
  findSignChanges(volume, 0.0, 1.0, [&](double time, bool downwards) {
    const TreeTriangle met = between(before, now, time);
    const Vec3 normal = met.doubleAreaNormal();
    const Vec3 point = path.from + time * (path.to - path.from);
    if (normal.isZero(0.0) || !isInTriangle(met, normal, point)) return;
    crossings.push_back(
        {time, downwards, normal, path.to - path.from - motionAt(before, now, met, normal, point)});
  });
}

bool touches(const TreeBox& box, const Path& path) {
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = path.from[axis], to = path.to[axis];
    if (std::max(from, to) < box.low[axis] || std::min(from, to) > box.high[axis]) return false;
    if (from == to) continue;
    const double one = (box.low[axis] - from) * path.inverse[axis];
    const double other = (box.high[axis] - from) * path.inverse[axis];
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return enter <= leave + 1e-12;  // rounding of the two times
}

}  // namespace

void findCrossings(const SurfaceTree& tree, const Vec3& from, const Vec3& to,
                   std::vector<Crossing>& crossings) {
  crossings.clear();
  const Path path{from, to, (to - from).cwiseInverse()};
  const std::size_t end = tree.nodes().size();
  for (std::size_t i = 0; i < end;) {
    const TreeNode& node = tree.nodes()[i];
    if (!touches(tree.sweptBoxes()[i], path)) {
      i = static_cast<std::size_t>(node.skip);
      continue;
    }
    ++i;
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(node.first) + k;
      crossTriangle(tree.previous()[index], tree.triangles()[index], path, crossings);
    }
  }
  // At the same time (a path through a sharp edge) leaving comes first: touching an edge is not passing
  // through.
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& one, const Crossing& other) {
    return std::pair(one.time, one.entering) < std::pair(other.time, other.entering);
  });
}

}  // namespace fissure
