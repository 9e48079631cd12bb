#include "surface/overlap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "base/reproducible.h"

namespace fissure {

namespace {

// Of the product of three lengths: more than the rounding of their determinant or of the sum of products that
// it is compared with.
constexpr double kUnclear = 1e-14;

bool isProvedOutside(const SurfacePart& part, std::span<const Vec3> vertices_m, const Vec3& point_m) {
  double angle = 0;
  for (const Face& face : part.faces) {
    const auto corner = [&](std::size_t i) {
      return Vec3(vertices_m[static_cast<std::size_t>(face[i])] - point_m);
    };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double size = la * lb * lc;
    const double volume = a.dot(b.cross(c));
    const double rest = size + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    // With the point in the triangle's plane the angle is 0, or half of the sphere on either side.
    if (!(std::abs(volume) > kUnclear * size) && !(rest > kUnclear * size)) return false;
    angle += 2 * reproducible::atan2(volume, rest);
  }
  return std::abs(angle) < std::numbers::pi;  // a quarter of one winding; NaN is not
}

}  // namespace

std::vector<SurfacePart> partsOf(const TriangleMesh& mesh) {
  std::vector<int> root(mesh.vertices_m.size());
  std::iota(root.begin(), root.end(), 0);
  const auto rootOf = [&](int vertex) {
    while (root[static_cast<std::size_t>(vertex)] != vertex) {
      int& parent = root[static_cast<std::size_t>(vertex)];
      parent = root[static_cast<std::size_t>(parent)];
      vertex = parent;
    }
    return vertex;
  };
  for (const Face& face : mesh.faces)
    for (const std::size_t i : {1u, 2u}) {
      const int one = rootOf(face[0]), other = rootOf(face[i]);
      root[static_cast<std::size_t>(std::max(one, other))] = std::min(one, other);
    }
  std::vector<SurfacePart> parts;
  std::map<int, std::size_t> part_of;  // by root
  for (const Face& face : mesh.faces) {
    const auto [known, is_new] = part_of.try_emplace(rootOf(face[0]), parts.size());
    if (is_new) parts.push_back({face[0], {}});
    parts[known->second].faces.push_back(face);
  }
  return parts;
}

bool isProvedOutside(std::span<const SurfacePart> parts, std::span<const Vec3> vertices_m,
                     const Vec3& point_m) {
  return std::all_of(parts.begin(), parts.end(),
                     [&](const SurfacePart& part) { return isProvedOutside(part, vertices_m, point_m); });
}

}  // namespace fissure
