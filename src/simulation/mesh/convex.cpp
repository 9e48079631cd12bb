#include "mesh/convex.h"

#include <algorithm>

namespace fissure {

bool isConvex(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& vertex : mesh.vertices_m) bounds.extend(vertex);
  const double slack_m = 1e-4 * bounds.sizes().maxCoeff();
  return std::all_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) {
    const Vec3& a = mesh.vertices_m[face[0]];
    const Vec3 ab = mesh.vertices_m[face[1]] - a, ac = mesh.vertices_m[face[2]] - a;
    const Vec3 area2 = ab.cross(ac);
    const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    if (area2.norm() <= 1e-4 * longest) return true;
    const Vec3 normal = area2.normalized();
    return std::all_of(mesh.vertices_m.begin(), mesh.vertices_m.end(),
                       [&](const Vec3& vertex) { return normal.dot(vertex - a) <= slack_m; });
  });
}

}  // namespace fissure
