#include "mesh/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace fissure {
namespace {

/// Twice the area over the longest edge squared: below this a triangle has no usable normal.
constexpr double flatness = 1e-12;

/// Volume over the cube of the extent: below this a closed surface is a folded sheet.
constexpr double emptiness = 1e-12;

/// The lines that findDefects returns.
class Report {
 public:
  /// Adds "`count` `one`/`many` (`meaning`)" when there is any.
  void add(std::size_t count, const std::string& one, const std::string& many, const std::string& meaning) {
    if (count == 0) return;
    lines_.push_back(std::to_string(count) + " " + (count == 1 ? one : many) + " (" + meaning + ")");
  }
  void add(const std::string& line) { lines_.push_back(line); }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

bool inRange(const Face& face, std::size_t vertices) {
  return std::all_of(face.begin(), face.end(),
                     [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < vertices; });
}

bool repeatsCorner(const Face& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

bool isFlat(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double longest_squared = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
  // A corner that is not finite is reported with the vertices, not here.
  return std::isfinite(longest_squared) && ab.cross(ac).norm() <= flatness * longest_squared;
}

void checkVertices(const TriangleMesh& mesh, const std::vector<Face>& faces, Report& report) {
  std::vector<char> used(mesh.vertices_m.size(), 0);
  for (const Face& face : faces)
    for (const int v : face) used[static_cast<std::size_t>(v)] = 1;
  std::vector<Vec3> finite;
  finite.reserve(mesh.vertices_m.size());
  std::copy_if(mesh.vertices_m.begin(), mesh.vertices_m.end(), std::back_inserter(finite),
               [](const Vec3& v) { return v.allFinite(); });
  report.add(mesh.vertices_m.size() - finite.size(), "non-finite vertex", "non-finite vertices",
             "a coordinate is infinite or not a number");
  report.add(static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)), "unreferenced vertex",
             "unreferenced vertices", "part of no triangle");
  const auto key = [](const Vec3& v) { return std::make_tuple(v.x(), v.y(), v.z()); };
  std::sort(finite.begin(), finite.end(), [&](const Vec3& a, const Vec3& b) { return key(a) < key(b); });
  const auto distinct = std::unique(finite.begin(), finite.end()) - finite.begin();
  report.add(finite.size() - static_cast<std::size_t>(distinct), "duplicate vertex", "duplicate vertices",
             "at the position of another one");
}

void checkTriangles(const TriangleMesh& mesh, const std::vector<Face>& faces, Report& report) {
  const auto degenerate = std::count_if(faces.begin(), faces.end(), [&](const Face& face) {
    const auto corner = [&](int k) -> const Vec3& {
      return mesh.vertices_m[static_cast<std::size_t>(face[k])];
    };
    if (repeatsCorner(face)) return true;
    return isFlat(corner(0), corner(1), corner(2));
  });
  report.add(static_cast<std::size_t>(degenerate), "degenerate triangle", "degenerate triangles",
             "without area, and so without a normal");
}

/// True when the surface is closed and consistently oriented.
bool checkEdges(const std::vector<Face>& faces, Report& report) {
  // Lower index, higher index, and whether the face runs along the edge from the lower to the higher one.
  std::vector<std::tuple<int, int, bool>> edges;
  edges.reserve(3 * faces.size());
  for (const Face& face : faces) {
    if (repeatsCorner(face)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = face[k], to = face[(k + 1) % 3];
      edges.emplace_back(std::min(from, to), std::max(from, to), from < to);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t boundary = 0, crowded = 0, inconsistent = 0;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::find_if(first, edges.end(), [&](const auto& edge) {
      return std::get<0>(edge) != std::get<0>(*first) || std::get<1>(edge) != std::get<1>(*first);
    });
    const auto uses = last - first;
    if (uses == 1) ++boundary;
    if (uses > 2) ++crowded;
    if (uses == 2 && std::get<2>(*first) == std::get<2>(*(first + 1))) ++inconsistent;
    first = last;
  }
  report.add(boundary, "boundary edge", "boundary edges", "the surface is open");
  report.add(crowded, "non-manifold edge", "non-manifold edges", "shared by more than two triangles");
  report.add(inconsistent, "inconsistently oriented edge", "inconsistently oriented edges",
             "its two triangles disagree about the outside");
  return boundary + crowded + inconsistent == 0;
}

void checkSense(const TriangleMesh& mesh, Report& report) {
  const double volume_m3 = signedVolume_m3(mesh);
  if (!std::isfinite(volume_m3)) return;  // reported with the vertices
  Eigen::AlignedBox3d bounds;
  for (const Face& face : mesh.faces)
    for (const int v : face) bounds.extend(mesh.vertices_m[static_cast<std::size_t>(v)]);
  const double extent_m = bounds.diagonal().norm();
  char number[32];
  std::snprintf(number, sizeof number, "%.6g", volume_m3);
  if (std::abs(volume_m3) <= emptiness * extent_m * extent_m * extent_m)
    report.add("no enclosed volume (the surface is a folded sheet)");
  else if (volume_m3 < 0)
    report.add("inside out (its volume is " + std::string(number) + " m^3: reverse all triangles)");
}

}  // namespace

std::vector<std::string> findDefects(const TriangleMesh& mesh) {
  if (mesh.faces.empty()) return {"no triangles (the surface is empty)"};
  std::vector<Face> faces;
  faces.reserve(mesh.faces.size());
  std::copy_if(mesh.faces.begin(), mesh.faces.end(), std::back_inserter(faces),
               [&](const Face& face) { return inRange(face, mesh.vertices_m.size()); });
  Report report;
  report.add(mesh.faces.size() - faces.size(), "triangle with an index out of range",
             "triangles with an index out of range",
             "there are " + std::to_string(mesh.vertices_m.size()) + " vertices, counted from 0");
  checkVertices(mesh, faces, report);
  checkTriangles(mesh, faces, report);
  const bool closed = checkEdges(faces, report);
  if (closed && faces.size() == mesh.faces.size()) checkSense(mesh, report);
  return report.take();
}

double signedVolume_m3(const TriangleMesh& mesh) {
  if (mesh.faces.empty()) return 0;
  // Measured from a vertex, not from the scene's origin: a small body far away would lose its digits.
  const Vec3 from = mesh.vertices_m[static_cast<std::size_t>(mesh.faces.front()[0])];
  double six_volumes_m3 = 0;
  for (const Face& face : mesh.faces) {
    const auto corner = [&](std::size_t k) {
      return Vec3(mesh.vertices_m[static_cast<std::size_t>(face[k])] - from);
    };
    six_volumes_m3 += corner(0).dot(corner(1).cross(corner(2)));
  }
  return six_volumes_m3 / 6;
}

}  // namespace fissure
