#include "contact/centroid_nodes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "contact/face_tree.h"

namespace fissure {

namespace {

/// Rays through the inside of a tool.
class Inside {
 public:
  explicit Inside(const TriangleMesh& surface) : surface_(surface), tree_(surface.vertices_m, surface.faces) {
    for (const Vec3& v : surface.vertices_m) box_.extend(v);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (x * 9 + y * 3 + z > 0) directions_.push_back(Vec3(x, y, z).normalized());
  }

  /// Through which triangle, and how far away, a ray leaves the tool. `from_m` may lie on the surface.
  std::optional<SurfaceHit> exit(const Vec3& from_m, const Vec3& direction) const {
    // A little ahead of its start: rounding must not let a ray hit the triangle that it starts on.
    const double extent_m = box_.sizes().maxCoeff();
    const double ahead_m = 1e-9 * extent_m;
    long long tests = 0;
    auto hit = tree_.firstHit(Ray(from_m + ahead_m * direction, direction, 2 * extent_m), surface_.vertices_m,
                              tests);
    if (!hit || !(hit->at.cosine > 0)) return std::nullopt;
    hit->at.distance_m += ahead_m;
    return hit;
  }

  /// Where a pairing ray leaves the tool; no value: nowhere, or it is too long (makeCentroidNodes).
  std::optional<SurfaceHit> pairingHit(const Vec3& from_m, const Vec3& normal, double limit) const {
    auto hit = exit(from_m, -normal);
    if (hit && hit->at.distance_m > limit * thickness_m(from_m - 0.5 * hit->at.distance_m * normal, normal))
      hit.reset();
    return hit;
  }

  /// The shortest chord through a point inside, among those in 13 directions and in `direction`; infinite
  /// where none meets the surface at both ends.
  double thickness_m(const Vec3& point_m, const Vec3& direction) const {
    double shortest_m = chord_m(point_m, direction);
    for (const Vec3& other : directions_) shortest_m = std::min(shortest_m, chord_m(point_m, other));
    return shortest_m;
  }

 private:
  double chord_m(const Vec3& point_m, const Vec3& direction) const {
    const auto ahead = exit(point_m, direction), behind = exit(point_m, -direction);
    return ahead && behind ? ahead->at.distance_m + behind->at.distance_m
                           : std::numeric_limits<double>::infinity();
  }

  const TriangleMesh& surface_;
  FaceTree tree_;
  Eigen::AlignedBox3d box_;
  std::vector<Vec3> directions_;  ///< edges, faces and corners of a cube, one of each opposite two
};

Vec3 centroidOf(const TriangleMesh& mesh, const Face& face) {
  return (mesh.vertices_m[face[0]] + mesh.vertices_m[face[1]] + mesh.vertices_m[face[2]]) / 3;
}

/// Zero for a triangle without an area.
Vec3 normalOf(const TriangleMesh& mesh, const Face& face) {
  const Vec3& a = mesh.vertices_m[face[0]];
  return (mesh.vertices_m[face[1]] - a).cross(mesh.vertices_m[face[2]] - a).normalized();
}

/// A corner of a triangle with a node, on the rim of what carries nodes.
struct RimCorner {
  int vertex = 0;
  int face = 0;
};

/// Corners where a triangle with a node meets one without, or turns by more than 60 degrees into another.
std::vector<RimCorner> rimCorners(const TriangleMesh& surface, const std::vector<int>& node_of_face) {
  std::map<std::array<int, 2>, std::vector<int>> faces_of_edge;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const Face& face = surface.faces[f];
    for (int j = 0; j < 3; ++j)
      faces_of_edge[{std::min(face[j], face[(j + 1) % 3]), std::max(face[j], face[(j + 1) % 3])}].push_back(
          static_cast<int>(f));
  }
  std::vector<RimCorner> corners;
  for (const auto& [edge, faces] : faces_of_edge) {
    for (const int face : faces) {
      if (node_of_face[face] < 0) continue;
      const Vec3 normal = normalOf(surface, surface.faces[face]);
      const bool rim =
          faces.size() != 2 || std::any_of(faces.begin(), faces.end(), [&](int other) {
            return node_of_face[other] < 0 || normal.dot(normalOf(surface, surface.faces[other])) < 0.5;
          });
      if (!rim) continue;
      corners.push_back({edge[0], face});
      corners.push_back({edge[1], face});
    }
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const RimCorner& a, const RimCorner& b) { return a.vertex < b.vertex; });
  return corners;
}

void addNode(const Vec3& position_m, const Vec3& normal, const std::optional<SurfaceHit>& hit,
             ToolNodes& nodes) {
  nodes.positions_m.push_back(position_m);
  nodes.normals.push_back(normal);
  nodes.partners.push_back(-1);
  nodes.thicknesses_m.push_back(hit ? hit->at.distance_m : std::numeric_limits<double>::infinity());
}

/// One node for all corners of a vertex whose triangles lie within 60 degrees. It stands a thousandth of the
/// way towards the middle of a triangle, so that its pairing ray has an inside to run through.
void addRimNodes(const TriangleMesh& surface, const Inside& inside, const std::vector<int>& node_of_face,
                 ToolNodes& nodes) {
  std::vector<RimCorner> corners = rimCorners(surface, node_of_face);
  while (!corners.empty()) {
    const RimCorner first = corners.front();
    const Vec3 normal = normalOf(surface, surface.faces[first.face]);
    Vec3 mean = Vec3::Zero();
    std::erase_if(corners, [&](const RimCorner& corner) {
      if (corner.vertex != first.vertex) return false;
      const Vec3 other = normalOf(surface, surface.faces[corner.face]);
      if (normal.dot(other) < 0.5) return false;
      mean += other;
      return true;
    });
    mean.normalize();
    const Vec3& vertex_m = surface.vertices_m[first.vertex];
    const Vec3 position_m = vertex_m + 1e-3 * (centroidOf(surface, surface.faces[first.face]) - vertex_m);
    const auto hit = inside.exit(position_m, -mean);
    const int across = hit ? node_of_face[hit->face] : -1;
    addNode(position_m, mean, hit, nodes);
    nodes.partners.back() = across >= 0 ? across : nodes.partners[node_of_face[first.face]];
  }
}

}  // namespace

ToolNodes makeCentroidNodes(const TriangleMesh& surface, const CentroidNodeSettings& settings) {
  const Inside inside(surface);
  ToolNodes nodes;
  std::vector<int> node_of_face(surface.faces.size(), -1);
  std::vector<int> exit_faces;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const Vec3 normal = normalOf(surface, surface.faces[f]);
    if (!(normal.squaredNorm() > 0)) continue;
    const Vec3 centroid_m = centroidOf(surface, surface.faces[f]);
    const auto hit = inside.pairingHit(centroid_m, normal, settings.pairing_limit);
    if (!hit && !settings.lone_nodes) continue;
    node_of_face[f] = nodes.size();
    addNode(centroid_m, normal, hit, nodes);
    exit_faces.push_back(hit ? hit->face : -1);
  }
  for (int i = 0; i < nodes.size(); ++i)
    if (exit_faces[i] >= 0) nodes.partners[i] = node_of_face[exit_faces[i]];
  if (settings.rim_nodes) addRimNodes(surface, inside, node_of_face, nodes);
  return nodes;
}

}  // namespace fissure
