#include "mesh/subdivide.h"

#include <array>
#include <map>
#include <utility>

namespace fissure {
namespace {

/// New vertices in the middle of long edges, one an edge.
class Midpoints {
 public:
  Midpoints(TriangleMesh& mesh, double max_edge) : mesh_(mesh), max_edge_(max_edge) {}

  /// Index of the vertex in the middle of an edge that is too long, else -1.
  int between(int a, int b) {
    const std::pair<int, int> edge = std::minmax(a, b);
    const Vec3 from = mesh_.vertices_m[edge.first], to = mesh_.vertices_m[edge.second];
    if ((to - from).norm() <= max_edge_) return -1;
    const auto [found, is_new] = made_.try_emplace(edge, static_cast<int>(mesh_.vertices_m.size()));
    if (is_new) mesh_.vertices_m.emplace_back(from + 0.5 * (to - from));
    return found->second;
  }

 private:
  TriangleMesh& mesh_;
  double max_edge_;
  std::map<std::pair<int, int>, int> made_;
};

/// The parts of a triangle whose side k (from corner k to the next) is halved at `middle[k]`, or not (-1).
void split(const TriangleMesh& mesh, const Face& face, const std::array<int, 3>& middle,
           std::vector<Face>& parts) {
  const auto halved = [&](std::size_t k) { return middle[k % 3] >= 0; };
  const int count = halved(0) + halved(1) + halved(2);
  if (count == 0) return parts.push_back(face);
  if (count == 3) {
    parts.insert(parts.end(), {{face[0], middle[0], middle[2]},
                               {middle[0], face[1], middle[1]},
                               {middle[2], middle[1], face[2]},
                               {middle[0], middle[1], middle[2]}});
    return;
  }
  // Turned so that side 0 is halved, and with two of them side 1 as well.
  std::size_t k = 0;
  while (!halved(k) || (count == 2 && !halved(k + 1))) ++k;
  const int a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3], ab = middle[k];
  if (count == 1) {
    parts.insert(parts.end(), {{a, ab, c}, {ab, b, c}});
    return;
  }
  const int bc = middle[(k + 1) % 3];
  const auto length = [&](int i, int j) { return (mesh.vertices_m[i] - mesh.vertices_m[j]).norm(); };
  parts.push_back({ab, b, bc});
  if (length(ab, c) < length(a, bc))
    parts.insert(parts.end(), {{a, ab, c}, {ab, bc, c}});
  else
    parts.insert(parts.end(), {{a, ab, bc}, {a, bc, c}});
}

}  // namespace

bool subdivide(TriangleMesh& mesh, double max_edge, std::size_t most) {
  for (;;) {
    Midpoints midpoints(mesh, max_edge);
    std::vector<Face> parts;
    for (const Face& face : mesh.faces) {
      const std::array<int, 3> middle = {midpoints.between(face[0], face[1]),
                                         midpoints.between(face[1], face[2]),
                                         midpoints.between(face[2], face[0])};
      split(mesh, face, middle, parts);
      if (parts.size() > most) return false;
    }
    const bool done = parts.size() == mesh.faces.size();
    mesh.faces = std::move(parts);
    if (done) return true;
  }
}

}  // namespace fissure
