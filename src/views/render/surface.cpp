#include "render/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/camera.h"

namespace fissure {
namespace {

/// Twice the area, along the outward normal.
Vec3 areaVector(std::span<const Vec3> vertices_m, const Face& face) {
  const Vec3& a = vertices_m[face[0]];
  return (vertices_m[face[1]] - a).cross(vertices_m[face[2]] - a);
}

Vec3 unitOrZero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3::Zero();
}

}  // namespace

Surface::Surface(std::vector<Face> faces, int vertex_count)
    : faces_(std::move(faces)), faces_around_(vertex_count) {
  for (int face = 0; face < static_cast<int>(faces_.size()); ++face) {
    for (const int vertex : faces_[face]) {
      faces_around_[vertex].push_back(face);
    }
  }
  findEdges();
}

void Surface::findEdges() {
  for (int face = 0; face < static_cast<int>(faces_.size()); ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      const auto [a, b] = std::minmax(faces_[face][corner], faces_[face][(corner + 1) % 3]);
      edges_.push_back({a, b, face, -1});
    }
  }
  const auto key = [](const SurfaceEdge& edge) { return std::array{edge.a, edge.b, edge.face_a}; };
  std::sort(edges_.begin(), edges_.end(), [&](const auto& l, const auto& r) { return key(l) < key(r); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (kept > 0 && edges_[kept - 1].a == edges_[i].a && edges_[kept - 1].b == edges_[i].b) {
      edges_[kept - 1].face_b = edges_[i].face_a;
    } else {
      edges_[kept++] = edges_[i];
    }
  }
  edges_.resize(kept);
}

bool Surface::faceDrawable(std::span<const Vec3> vertices_m, int face) const {
  return std::all_of(faces_[face].begin(), faces_[face].end(),
                     [&](int v) { return drawable(vertices_m[v]); });
}

std::vector<Vec3> Surface::faceNormals(std::span<const Vec3> vertices_m) const {
  std::vector<Vec3> normals(faces_.size(), Vec3::Zero());
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    if (faceDrawable(vertices_m, static_cast<int>(face))) {
      normals[face] = unitOrZero(areaVector(vertices_m, faces_[face]));
    }
  }
  return normals;
}

std::vector<std::array<Vec3, 3>> Surface::cornerNormals(std::span<const Vec3> vertices_m,
                                                        double crease_deg) const {
  const double least_cosine = std::cos(crease_deg * std::numbers::pi / 180);
  const std::vector<Vec3> normals = faceNormals(vertices_m);
  std::vector<std::array<Vec3, 3>> corners(faces_.size());
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      Vec3 sum = Vec3::Zero();
      for (const int other : faces_around_[faces_[face][corner]]) {
        if (normals[other].dot(normals[face]) > least_cosine) {
          sum += areaVector(vertices_m, faces_[other]);
        }
      }
      corners[face][corner] = unitOrZero(sum);
    }
  }
  return corners;
}

namespace {

using Triangle = std::array<Vec3, 3>;

/// Appends the points where edges of `edges` pass through the triangle `target`.
void addPiercings(const Triangle& edges, const Triangle& target, std::vector<Vec3>& points_m) {
  const Vec3 normal = (target[1] - target[0]).cross(target[2] - target[0]);
  for (int i = 0; i < 3; ++i) {
    const double from = normal.dot(edges[i] - target[0]);
    const double to = normal.dot(edges[(i + 1) % 3] - target[0]);
    if ((from < 0) == (to < 0)) {
      continue;
    }
    const Vec3 point_m = edges[i] + from / (from - to) * (edges[(i + 1) % 3] - edges[i]);
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      inside = inside && normal.dot((target[(k + 1) % 3] - target[k]).cross(point_m - target[k])) >= 0;
    }
    if (inside) {
      points_m.push_back(point_m);
    }
  }
}

Eigen::AlignedBox3d boxOf(const Triangle& triangle) {
  Eigen::AlignedBox3d box(triangle[0]);
  return box.extend(triangle[1]).extend(triangle[2]);
}

/// The drawable triangles that reach into `where`.
std::vector<Triangle> trianglesIn(const Eigen::AlignedBox3d& where, const std::vector<Face>& faces,
                                  std::span<const Vec3> vertices_m) {
  std::vector<Triangle> found;
  for (const Face& face : faces) {
    const Triangle triangle = {vertices_m[face[0]], vertices_m[face[1]], vertices_m[face[2]]};
    if (std::all_of(triangle.begin(), triangle.end(), drawable) && where.intersects(boxOf(triangle))) {
      found.push_back(triangle);
    }
  }
  return found;
}

Eigen::AlignedBox3d boxOf(std::span<const Vec3> vertices_m) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex_m : vertices_m) {
    if (drawable(vertex_m)) {
      box.extend(vertex_m);
    }
  }
  return box;
}

}  // namespace

std::vector<std::array<Vec3, 2>> cutSegments(const std::vector<Face>& faces_a,
                                             std::span<const Vec3> vertices_a_m,
                                             const std::vector<Face>& faces_b,
                                             std::span<const Vec3> vertices_b_m) {
  const Eigen::AlignedBox3d shared = boxOf(vertices_a_m).intersection(boxOf(vertices_b_m));
  std::vector<std::array<Vec3, 2>> segments;
  if (shared.isEmpty()) {
    return segments;
  }
  const std::vector<Triangle> all_b = trianglesIn(shared, faces_b, vertices_b_m);
  for (const Triangle& a : trianglesIn(shared, faces_a, vertices_a_m)) {
    const Eigen::AlignedBox3d box_a = boxOf(a);
    for (const Triangle& b : all_b) {
      if (!box_a.intersects(boxOf(b))) {
        continue;
      }
      std::vector<Vec3> points_m;
      addPiercings(a, b, points_m);
      addPiercings(b, a, points_m);
      if (points_m.size() >= 2) {
        const auto farther = [&](const Vec3& l, const Vec3& r) {
          return (l - points_m[0]).squaredNorm() < (r - points_m[0]).squaredNorm();
        };
        segments.push_back({points_m[0], *std::max_element(points_m.begin(), points_m.end(), farther)});
      }
    }
  }
  return segments;
}

}  // namespace fissure
