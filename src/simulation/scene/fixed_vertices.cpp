#include "scene/fixed_vertices.h"

#include <set>

namespace fissure {

namespace {

bool holds(const BoxRegion& box, const Vec3& point_m) {
  return (point_m.array() >= box.min_m.array()).all() && (point_m.array() <= box.max_m.array()).all();
}

bool holds(const FixedRegion& region, const Vec3& point_m) {
  return region.below_m ? point_m.y() <= *region.below_m : holds(*region.box, point_m);
}

template <class Region>
std::vector<int> verticesHeldBy(const Region& region, std::span<const Vec3> vertices_m) {
  std::vector<int> inside;
  for (std::size_t v = 0; v < vertices_m.size(); ++v) {
    if (holds(region, vertices_m[v])) inside.push_back(static_cast<int>(v));
  }
  return inside;
}

}  // namespace

std::vector<int> verticesIn(const FixedRegion& region, const TriangleMesh& rest) {
  return verticesHeldBy(region, rest.vertices_m);
}

std::vector<int> verticesIn(const BoxRegion& box, const TriangleMesh& rest) {
  return verticesHeldBy(box, rest.vertices_m);
}

std::vector<int> fixedVertices(const BodySettings& body, std::span<const Vec3> vertices_m) {
  std::set<int> fixed;
  for (const FixedRegion& region : body.fixed) {
    const std::vector<int> inside = verticesHeldBy(region, vertices_m);
    fixed.insert(inside.begin(), inside.end());
  }
  return {fixed.begin(), fixed.end()};
}

}  // namespace fissure
