#include "contact/surface_features.h"

#include <algorithm>
#include <map>

namespace fissure {

namespace {

Vec3 unitNormal(const TriangleMesh& mesh, int face) {
  const Face& f = mesh.faces[static_cast<std::size_t>(face)];
  const Vec3& a = mesh.vertices_m[f[0]];
  return (mesh.vertices_m[f[1]] - a).cross(mesh.vertices_m[f[2]] - a).normalized();
}

bool isFlat(const TriangleMesh& mesh, const SurfaceEdge& edge) {
  constexpr double kCoplanar = 1 - 1e-12;  // cosine of the angle between the normals
  return edge.faces[1] >= 0 &&
         unitNormal(mesh, edge.faces[0]).dot(unitNormal(mesh, edge.faces[1])) > kCoplanar;
}

}  // namespace

SurfaceFeatures::SurfaceFeatures(const TriangleMesh& mesh, bool flat_edges)
    : faces_(mesh.faces),
      owned_(mesh.faces.size()),
      neighbours_(mesh.vertices_m.size()),
      faces_at_(mesh.vertices_m.size()) {
  std::map<std::pair<int, int>, std::size_t> known;
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = faces_[f][i], to = faces_[f][(i + 1) % 3];
      if (faces_at_[from].empty()) owned_[f].corners[i] = from;
      faces_at_[from].push_back(static_cast<int>(f));
      const auto [place, is_new] = known.try_emplace(std::minmax(from, to), edges_.size());
      if (is_new) {
        edges_.push_back({.from = from, .to = to, .faces = {static_cast<int>(f), -1}});
        neighbours_[from].push_back(to);
        neighbours_[to].push_back(from);
      } else {
        edges_[place->second].faces[1] = static_cast<int>(f);
      }
    }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const SurfaceEdge& edge = edges_[e];
    FaceFeatures& owner = owned_[edge.faces[0]];
    if (!flat_edges && isFlat(mesh, edge)) {
      const Face& face = faces_[edge.faces[0]];
      owner.flat[std::find(face.begin(), face.end(), opposite(edge, 0)) - face.begin()] = 1;
      continue;
    }
    *std::find(owner.edges.begin(), owner.edges.end(), -1) = static_cast<int>(e);
  }
  findShells();
}

void SurfaceFeatures::findShells() {
  std::vector<std::uint8_t> seen(neighbours_.size());
  std::vector<int> next;
  for (const Face& face : faces_) {
    if (seen[face[0]]) continue;
    shells_.push_back(face[0]);
    seen[face[0]] = 1;
    next.push_back(face[0]);
    while (!next.empty()) {
      const int vertex = next.back();
      next.pop_back();
      for (const int other : neighbours_[vertex])
        if (!seen[other]) next.push_back(other), seen[other] = 1;
    }
  }
}

int SurfaceFeatures::opposite(const SurfaceEdge& edge, int side) const {
  const Face& face = faces_[edge.faces[side]];
  return *std::find_if(face.begin(), face.end(),
                       [&](int corner) { return corner != edge.from && corner != edge.to; });
}

}  // namespace fissure
