#include "slow_penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fissure::test {

namespace {

Vec3 cornerOf(const TriangleMesh& mesh, const Face& face, std::size_t i) {
  return mesh.vertices_m[static_cast<std::size_t>(face[i])];
}

/// Angle at the ray along `a` between the planes through it and `b`, and it and `c`.
double dihedralAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 one = a.cross(b), other = a.cross(c);
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

double planarDistance_m(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point_m) {
  const Vec3 x_axis = (b - a).normalized();
  const Vec3 z_axis = x_axis.cross(c - a).normalized();
  const Vec3 y_axis = z_axis.cross(x_axis);
  const auto flat = [&](const Vec3& p) { return Eigen::Vector2d(x_axis.dot(p - a), y_axis.dot(p - a)); };
  const std::array<Eigen::Vector2d, 3> outline = {flat(a), flat(b), flat(c)};
  const Eigen::Vector2d foot = flat(point_m);
  const double height_m = z_axis.dot(point_m - a);
  bool inside = true;
  double beside_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d along = outline[(i + 1) % 3] - outline[i], to_foot = foot - outline[i];
    inside = inside && along.x() * to_foot.y() - along.y() * to_foot.x() >= 0;
    const double share = std::min(1.0, std::max(0.0, along.dot(to_foot) / along.dot(along)));
    beside_m = std::min(beside_m, (to_foot - share * along).norm());
  }
  return inside ? std::abs(height_m) : std::hypot(height_m, beside_m);
}

}  // namespace

double girardWinding(const TriangleMesh& mesh, const Vec3& point_m) {
  double total = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 a = (cornerOf(mesh, face, 0) - point_m).normalized();
    const Vec3 b = (cornerOf(mesh, face, 1) - point_m).normalized();
    const Vec3 c = (cornerOf(mesh, face, 2) - point_m).normalized();
    const double angles = dihedralAngle(a, b, c) + dihedralAngle(b, c, a) + dihedralAngle(c, a, b);
    total += std::copysign(angles - std::numbers::pi, a.dot(b.cross(c)));
  }
  return total / (4 * std::numbers::pi);
}

double planarDistance_m(const TriangleMesh& mesh, const Vec3& point_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Face& face : mesh.faces)
    nearest_m = std::min(nearest_m, planarDistance_m(cornerOf(mesh, face, 0), cornerOf(mesh, face, 1),
                                                     cornerOf(mesh, face, 2), point_m));
  return nearest_m;
}

double sidesDistance_m(const Vec3& size_m, const Vec3& point_m) {
  bool inside = true;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      Vec3 projected_m;
      for (int k = 0; k < 3; ++k)
        projected_m[k] =
            k == axis ? side * size_m[k] : std::min(0.5 * size_m[k], std::max(-0.5 * size_m[k], point_m[k]));
      nearest_m = std::min(nearest_m, (point_m - projected_m).norm());
      inside = inside && point_m[axis] / side < size_m[axis];
    }
  }
  return inside ? -nearest_m : nearest_m;
}

void measureSlowly(const TriangleMesh& body, const Vec3& tool_size_m, const Pose& tool,
                   std::span<const Vec3> samples_m, SlowPenetration& result) {
  for (const Vec3& sample_m : samples_m) {
    const Vec3 point_m = tool.toScene(sample_m);
    const double winding = girardWinding(body, point_m);
    const double distance_m = planarDistance_m(body, point_m);
    if (winding > 0.5) result.depth_m = std::max(result.depth_m, distance_m);
    if (winding < -0.5 || winding > 1.5) ++result.odd_samples;
    result.gap_m = std::min(result.gap_m, distance_m);
  }
  for (const Vec3& vertex_m : body.vertices_m) {
    const double distance_m = sidesDistance_m(tool_size_m, tool.toBody(vertex_m));
    result.depth_m = std::max(result.depth_m, -distance_m);
    result.gap_m = std::min(result.gap_m, distance_m);
  }
}

}  // namespace fissure::test
