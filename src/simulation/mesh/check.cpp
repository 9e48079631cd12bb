#include "mesh/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/reproducible.h"
#include "mesh/defect_list.h"
#include "mesh/edges.h"
#include "mesh/shells.h"
#include "mesh/triangle.h"

namespace fissure {
namespace {

/// relativeHeight() below which a triangle is a sliver: area over longest edge squared 1e-6.
constexpr double sliver_height = 2e-6;

/// Volume over the cube of the extent: below this a closed surface is a folded sheet.
constexpr double emptiness = 1e-12;

/// Over the extent of a mesh: vertices that are nearer to each other were one when the mesh was made.
constexpr double coincidence = 1e-5;
/// Per point that may coincide with another.
constexpr std::size_t most_looks = 200;

using Report = DefectList<Defect>;

bool inRange(const Face& face, std::size_t vertices) {
  return std::all_of(face.begin(), face.end(),
                     [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < vertices; });
}

void checkVertices(const TriangleMesh& mesh, Report& report) {
  std::vector<char> used(mesh.vertices_m.size(), 0);
  for (const Face& face : mesh.faces)
    for (const int v : face) used[static_cast<std::size_t>(v)] = 1;
  std::vector<Vec3> finite;
  finite.reserve(mesh.vertices_m.size());
  std::copy_if(mesh.vertices_m.begin(), mesh.vertices_m.end(), std::back_inserter(finite),
               [](const Vec3& v) { return v.allFinite(); });
  report.add(DefectKind::non_finite_vertices, mesh.vertices_m.size() - finite.size(), "non-finite vertex",
             "non-finite vertices", "a coordinate is infinite or not a number");
  report.add(DefectKind::unreferenced_vertices,
             static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)), "unreferenced vertex",
             "unreferenced vertices", "part of no triangle");
  const auto key = [](const Vec3& v) { return std::make_tuple(v.x(), v.y(), v.z()); };
  std::sort(finite.begin(), finite.end(), [&](const Vec3& a, const Vec3& b) { return key(a) < key(b); });
  const auto distinct = std::unique(finite.begin(), finite.end()) - finite.begin();
  report.add(DefectKind::duplicate_vertices, finite.size() - static_cast<std::size_t>(distinct),
             "duplicate vertex", "duplicate vertices", "at the position of another one");
}

void checkTriangles(const TriangleMesh& mesh, Report& report) {
  std::size_t degenerate = 0, slivers = 0;
  std::set<Face> seen;
  for (const Face& face : mesh.faces) {
    // A corner that is not finite is told with the vertices: it makes this NaN.
    const double height = repeatsCorner(face) ? 0 : relativeHeight(cornersOf(mesh, face));
    degenerate += height <= degenerate_height;
    slivers += height < sliver_height;
    Face corners = face;
    std::sort(corners.begin(), corners.end());
    seen.insert(corners);
  }
  report.add(DefectKind::degenerate_triangles, degenerate, "degenerate triangle", "degenerate triangles",
             "without area, and so without a normal");
  if (slivers > degenerate)
    report.add(DefectKind::sliver_triangles, slivers, "sliver triangle", "sliver triangles",
               "area below a millionth of the longest edge squared");
  report.add(DefectKind::duplicate_faces, mesh.faces.size() - seen.size(), "duplicate face",
             "duplicate faces", "the same three corners as another one");
}

/// What to do about an open surface of which most vertices at the rims nearly coincide with another one, as
/// if a surface had been written piece by piece; else "".
std::string weldHint(const TriangleMesh& mesh, const std::set<int>& rim, double unit_m) {
  Eigen::AlignedBox3d bounds;
  std::vector<Vec3> points;
  for (const int vertex : rim) {
    const Vec3& point = points.emplace_back(mesh.vertices_m[static_cast<std::size_t>(vertex)]);
    bounds.extend(point);
    if (!point.allFinite()) return "";
  }
  if (points.empty()) return "";
  const double near = coincidence * bounds.diagonal().norm();
  Eigen::Index axis = 0;
  bounds.sizes().maxCoeff(&axis);
  std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  std::vector<char> paired(points.size(), 0);
  double farthest = 0;
  std::size_t looks = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size() && points[j][axis] - points[i][axis] <= near; ++j) {
      if (++looks > most_looks * points.size()) return "";  // too many in one plane for a hint
      const double distance = (points[j] - points[i]).norm();
      if (!(distance <= near) || distance == 0) continue;
      paired[i] = paired[j] = 1;
      farthest = std::max(farthest, distance);
    }
  const auto pairs = static_cast<std::size_t>(std::count(paired.begin(), paired.end(), 1));
  if (2 * pairs <= points.size()) return "";
  return fmt::format(
      ", but {} of its {} rim vertices nearly coincide with another: weld_tolerance_m: {:.1g} may close it",
      pairs, points.size(), 2 * farthest * unit_m);
}

/// True when the surface is closed and consistently oriented.
bool checkEdges(const TriangleMesh& mesh, double unit_m, Report& report) {
  const std::vector<Face>& faces = mesh.faces;
  std::size_t boundary = 0, crowded = 0, inconsistent = 0;
  std::set<int> rim;
  forEachEdge(edgeUses(faces), [&](auto first, auto last) {
    const auto forward = std::count_if(first, last, [](const EdgeUse& use) { return use.forward; });
    const auto uses = last - first;
    boundary += uses == 1;
    if (uses == 1) rim.insert({first->low, first->high});
    crowded += uses > 2;
    inconsistent += static_cast<std::size_t>(forward > 1) + static_cast<std::size_t>(uses - forward > 1);
  });
  report.add(DefectKind::boundary_edges, boundary, "boundary edge", "boundary edges",
             "the surface is open" + weldHint(mesh, rim, unit_m));
  report.add(DefectKind::non_manifold_edges, crowded, "non-manifold edge", "non-manifold edges",
             "shared by more than two triangles");
  report.add(DefectKind::inconsistent_edges, inconsistent, "inconsistently oriented edge",
             "inconsistently oriented edges", "its triangles disagree about the outside");
  return boundary + crowded + inconsistent == 0;
}

std::string insideOut(std::size_t inward, std::size_t shells, double volume_m3) {
  if (shells > 1)
    return fmt::format("{} of {} shells inside out (and no cavity of another one)", inward, shells);
  return fmt::format("inside out (its volume is {:.6g} m^3: reverse all triangles)", volume_m3);
}

/// Reports which shells of a closed and consistent surface are inside out, or that it encloses no volume.
void checkSense(const TriangleMesh& mesh, double unit_m, const std::vector<std::vector<Face>>& shells,
                Report& report) {
  const double volume = signedVolume(mesh, mesh.faces);
  if (!std::isfinite(volume)) return;  // told with the vertices
  Eigen::AlignedBox3d bounds;
  for (const Face& face : mesh.faces)
    for (const Vec3& corner : cornersOf(mesh, face)) bounds.extend(corner);
  if (shells.size() == 1 && std::abs(volume) <= emptiness * reproducible::pow(bounds.diagonal().norm(), 3))
    return report.add(DefectKind::no_volume, "no enclosed volume (the surface is a folded sheet)");
  const Nesting nesting(mesh, shells);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < shells.size(); ++i)
    wrong += signedVolume(mesh, shells[i]) < 0 && nesting.depth(i) % 2 == 0;
  if (wrong > 0)
    report.add(DefectKind::inside_out,
               insideOut(wrong, shells.size(), volume * reproducible::pow(unit_m, 3)));
}

}  // namespace

std::vector<Defect> inspectSurface(const TriangleMesh& mesh, double unit_m) {
  Report report;
  if (mesh.faces.empty()) {
    report.add(DefectKind::no_triangles, "no triangles (the surface is empty)");
    return report.take();
  }
  TriangleMesh good{mesh.vertices_m, {}};
  good.faces.reserve(mesh.faces.size());
  std::copy_if(mesh.faces.begin(), mesh.faces.end(), std::back_inserter(good.faces),
               [&](const Face& face) { return inRange(face, mesh.vertices_m.size()); });
  report.add(DefectKind::index_out_of_range, mesh.faces.size() - good.faces.size(),
             "triangle with an index out of range", "triangles with an index out of range",
             fmt::format("there are {} vertices, counted from 0", mesh.vertices_m.size()));
  checkVertices(good, report);
  checkTriangles(good, report);
  const bool closed = checkEdges(good, unit_m, report);
  const std::vector<std::vector<Face>> shells = splitShells(good);
  if (closed && !good.faces.empty() && good.faces.size() == mesh.faces.size())
    checkSense(good, unit_m, shells, report);
  if (shells.size() > 1)
    report.add(DefectKind::shells, shells.size(), "shell", "shells", "pieces that share no vertex");
  return report.take();
}

bool spoilsBody(DefectKind kind) {
  switch (kind) {
    case DefectKind::sliver_triangles:
    case DefectKind::shells:
    case DefectKind::unused_vertices:
    case DefectKind::non_planar_polygons:
      return false;
    default:
      return true;
  }
}

bool spoilsTool(DefectKind kind) {
  switch (kind) {
    case DefectKind::no_triangles:
    case DefectKind::index_out_of_range:
    case DefectKind::non_finite_vertices:
    case DefectKind::inconsistent_edges:
    case DefectKind::inside_out:
    case DefectKind::size:
      return true;
    default:
      return false;
  }
}

bool hasInside(const TriangleMesh& mesh) {
  const std::vector<Defect> defects = inspectSurface(mesh);
  return std::none_of(defects.begin(), defects.end(), [](const Defect& defect) {
    switch (defect.kind) {
      case DefectKind::boundary_edges:
      case DefectKind::non_manifold_edges:
      case DefectKind::no_volume:
        return true;
      default:
        return spoilsTool(defect.kind);
    }
  });
}

double signedVolume_m3(const TriangleMesh& mesh) {
  return signedVolume(mesh, mesh.faces);
}

}  // namespace fissure
