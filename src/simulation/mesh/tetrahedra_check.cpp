#include "mesh/tetrahedra_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/defect_list.h"
#include "mesh/tetrahedron.h"
#include "mesh/tetrahedron_faces.h"

namespace fissure {
namespace {

/// relativeVolume() up to which a tetrahedron is flat.
constexpr double flat_volume = 1e-12;

/// radiusRatio() below which a tetrahedron is a sliver.
constexpr double sliver_ratio = 0.01;

using VolumeDefects = DefectList<VolumeDefect>;

void checkVertices(const TetrahedralMesh& mesh, VolumeDefects& report) {
  std::vector<char> used(mesh.vertices_m.size(), 0);
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (const int v : tetrahedron) used[static_cast<std::size_t>(v)] = 1;
  const auto bad = std::count_if(mesh.vertices_m.begin(), mesh.vertices_m.end(),
                                 [](const Vec3& v) { return !v.allFinite(); });
  report.add(VolumeDefectKind::non_finite_vertices, static_cast<std::size_t>(bad), "non-finite vertex",
             "non-finite vertices", "a coordinate is infinite or not a number");
  report.add(VolumeDefectKind::unused_vertices,
             static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)), "unused vertex",
             "unused vertices", "part of no tetrahedron");
}

void checkShapes(const TetrahedralMesh& mesh, VolumeDefects& report) {
  std::size_t inverted = 0, flat = 0, slivers = 0;
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra) {
    const std::array<Vec3, 4> corners = cornersOf(mesh, tetrahedron);
    // A corner that is not finite is told with the vertices: it makes this NaN.
    const double volume = repeatsCorner(tetrahedron) ? 0 : relativeVolume(corners);
    inverted += volume < -flat_volume;
    flat += std::abs(volume) <= flat_volume;
    slivers += volume > flat_volume && radiusRatio(corners) < sliver_ratio;
  }
  report.add(VolumeDefectKind::inverted_tetrahedra, inverted, "inverted tetrahedron", "inverted tetrahedra",
             "of negative volume");
  report.add(VolumeDefectKind::flat_tetrahedra, flat, "flat tetrahedron", "flat tetrahedra",
             "without volume");
  report.add(VolumeDefectKind::sliver_tetrahedra, slivers, "sliver tetrahedron", "sliver tetrahedra",
             "radius ratio below 0.01, where a regular one has 1");
}

/// The least number of a piece that tetrahedron `t` is in, halving the way there for the next time.
int rootOf(std::vector<int>& parent, int t) {
  for (auto at = static_cast<std::size_t>(t); parent[at] != t; at = static_cast<std::size_t>(t)) {
    parent[at] = parent[static_cast<std::size_t>(parent[at])];
    t = parent[at];
  }
  return t;
}

/// The number of pieces that the tetrahedra form, where those that share a side belong to the same piece.
std::size_t countPieces(const std::vector<Tetrahedron>& tetrahedra,
                        const std::vector<TetrahedronFace>& uses) {
  std::vector<int> parent(tetrahedra.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::size_t pieces = uses.size() / 4;
  forEachFace(uses, [&](auto first, auto last) {
    for (auto use = first + 1; use < last; ++use) {
      const auto [low, high] =
          std::minmax({rootOf(parent, first->tetrahedron), rootOf(parent, use->tetrahedron)});
      if (low == high) continue;
      parent[static_cast<std::size_t>(high)] = low;
      --pieces;
    }
  });
  return pieces;
}

/// Turned so that the least vertex comes first.
Face turned(Face face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Triangles that one of the two lists has and the other has not, whichever corner they begin with.
std::size_t countDifferent(std::vector<Face> boundary, std::vector<Face> surface) {
  for (std::vector<Face>* faces : {&boundary, &surface}) {
    std::transform(faces->begin(), faces->end(), faces->begin(), turned);
    std::sort(faces->begin(), faces->end());
  }
  std::vector<Face> different;
  std::set_symmetric_difference(boundary.begin(), boundary.end(), surface.begin(), surface.end(),
                                std::back_inserter(different));
  return different.size();
}

void checkSides(const TetrahedralMesh& mesh, const TriangleMesh& surface, VolumeDefects& report) {
  const std::vector<TetrahedronFace> uses = tetrahedronFaces(mesh.tetrahedra, mesh.vertices_m.size());
  std::size_t overlapping = 0;
  std::vector<Face> boundary;
  forEachFace(uses, [&](auto first, auto last) {
    const auto count = last - first;
    if (count == 1) boundary.push_back(first->outward);
    overlapping += count > 2 || (count == 2 && first->forward == (first + 1)->forward);
  });
  report.add(VolumeDefectKind::overlapping_faces, overlapping, "overlapping side", "overlapping sides",
             "of more than two tetrahedra, or of two on the same side of it");
  std::size_t others = 0;
  for (std::size_t v = 0; v < surface.vertices_m.size(); ++v)
    others += v >= mesh.vertices_m.size() || mesh.vertices_m[v] != surface.vertices_m[v];
  report.add(VolumeDefectKind::other_vertices, others, "other vertex", "other vertices",
             "not where the surface's vertex of the same number is");
  report.add(VolumeDefectKind::other_boundary, countDifferent(std::move(boundary), surface.faces),
             "other boundary triangle", "other boundary triangles",
             "of the boundary and not of the surface, or the other way round");
  const std::size_t pieces = countPieces(mesh.tetrahedra, uses);
  if (pieces > 1)
    report.add(VolumeDefectKind::pieces, pieces, "piece", "pieces", "that share no side of a tetrahedron");
}

}  // namespace

std::vector<VolumeDefect> inspectTetrahedra(const TetrahedralMesh& mesh, const TriangleMesh& surface) {
  VolumeDefects report;
  if (mesh.tetrahedra.empty()) {
    report.add(VolumeDefectKind::no_tetrahedra, "no tetrahedra (the volume is empty)");
    return report.take();
  }
  TetrahedralMesh good{mesh.vertices_m, {}};
  std::copy_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), std::back_inserter(good.tetrahedra),
               [&](const Tetrahedron& tetrahedron) {
                 return std::all_of(tetrahedron.begin(), tetrahedron.end(), [&](int v) {
                   return v >= 0 && static_cast<std::size_t>(v) < mesh.vertices_m.size();
                 });
               });
  report.add(VolumeDefectKind::index_out_of_range, mesh.tetrahedra.size() - good.tetrahedra.size(),
             "tetrahedron with an index out of range", "tetrahedra with an index out of range",
             fmt::format("there are {} vertices, counted from 0", mesh.vertices_m.size()));
  checkVertices(good, report);
  checkShapes(good, report);
  checkSides(good, surface, report);
  return report.take();
}

bool spoilsVolume(VolumeDefectKind kind) {
  return kind != VolumeDefectKind::sliver_tetrahedra;
}

TetrahedraQuality qualityOf(const TetrahedralMesh& mesh) {
  if (mesh.tetrahedra.empty()) return {};
  TetrahedraQuality quality{.worst = 1};
  double lost_m3 = 0;  // by rounding of the sum (Kahan 1965)
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra) {
    const std::array<Vec3, 4> corners = cornersOf(mesh, tetrahedron);
    const double ratio = radiusRatio(corners);
    quality.worst = std::min(quality.worst, ratio);
    quality.mean += ratio;
    const double volume_m3 = signedVolume(corners) - lost_m3, sum_m3 = quality.volume_m3 + volume_m3;
    lost_m3 = (sum_m3 - quality.volume_m3) - volume_m3;
    quality.volume_m3 = sum_m3;
  }
  quality.mean /= static_cast<double>(mesh.tetrahedra.size());
  return quality;
}

}  // namespace fissure
