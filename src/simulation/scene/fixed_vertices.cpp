#include "scene/fixed_vertices.h"

#include <set>

namespace fissure {

namespace {

bool holds(const BoxRegion& box, const Vec3& point_m) {
  return box.holds(point_m);
}

bool holds(const FixedRegion& region, const Vec3& point_m) {
  return region.below_m ? point_m.y() <= *region.below_m : region.box->holds(point_m);
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
