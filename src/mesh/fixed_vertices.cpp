#include "mesh/fixed_vertices.h"

#include <set>

namespace fissure {

namespace {

bool holds(const FixedRegion& region, const Vec3& point_m) {
  if (region.below_m) return point_m.y() <= *region.below_m;
  return (point_m.array() >= region.box->min_m.array()).all() &&
         (point_m.array() <= region.box->max_m.array()).all();
}

}  // namespace

std::vector<int> verticesIn(const FixedRegion& region, const TriangleMesh& rest) {
  std::vector<int> inside;
  for (std::size_t v = 0; v < rest.vertices_m.size(); ++v) {
    if (holds(region, rest.vertices_m[v])) inside.push_back(static_cast<int>(v));
  }
  return inside;
}

std::vector<int> fixedVertices(const BodySettings& body, const TriangleMesh& rest) {
  std::set<int> fixed;
  for (const FixedRegion& region : body.fixed) {
    const std::vector<int> inside = verticesIn(region, rest);
    fixed.insert(inside.begin(), inside.end());
  }
  return {fixed.begin(), fixed.end()};
}

}  // namespace fissure
