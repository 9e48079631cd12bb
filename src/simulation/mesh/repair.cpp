#include "mesh/repair.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/counted.h"
#include "mesh/edges.h"
#include "mesh/orient.h"
#include "mesh/shells.h"
#include "mesh/triangle.h"
#include "scenario/catalog.h"

namespace fissure {
namespace {

std::vector<char> usedVertices(const TriangleMesh& mesh) {
  std::vector<char> used(mesh.vertices_m.size(), 0);
  for (const Face& face : mesh.faces)
    for (const int v : face) used[static_cast<std::size_t>(v)] = 1;
  return used;
}

/// Leaves the vertices that `keep` names. Returns how many went.
std::size_t compact(TriangleMesh& mesh, const std::vector<char>& keep) {
  std::vector<int> number(keep.size(), -1);
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (!keep[v]) continue;
    number[v] = static_cast<int>(kept.size());
    kept.push_back(mesh.vertices_m[v]);
  }
  const std::size_t gone = keep.size() - kept.size();
  mesh.vertices_m = std::move(kept);
  for (Face& face : mesh.faces)
    for (int& v : face) v = number[static_cast<std::size_t>(v)];
  return gone;
}

/// Drops the triangles that `drop` names, and the vertices that were theirs alone. Returns how many triangles
/// went.
std::size_t dropFaces(TriangleMesh& mesh, const std::vector<char>& drop) {
  const std::vector<char> before = usedVertices(mesh);
  std::vector<Face> kept;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (!drop[f]) kept.push_back(mesh.faces[f]);
  const std::size_t gone = mesh.faces.size() - kept.size();
  mesh.faces = std::move(kept);
  std::vector<char> keep = usedVertices(mesh);
  for (std::size_t v = 0; v < keep.size(); ++v) keep[v] = keep[v] || !before[v];
  compact(mesh, keep);
  return gone;
}

std::string dropDegenerate(TriangleMesh& mesh) {
  std::vector<char> drop;
  for (const Face& face : mesh.faces)
    drop.push_back(repeatsCorner(face) || relativeHeight(cornersOf(mesh, face)) <= degenerate_height);
  const std::size_t count = dropFaces(mesh, drop);
  return count > 0 ? counted(count, "triangle") : "";
}

/// The corners in rising order, and whether an even permutation leads there.
std::pair<Face, bool> sortedCorners(Face face) {
  bool even = true;
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}}) {
    if (face[i] <= face[j]) continue;
    std::swap(face[i], face[j]);
    even = !even;
  }
  return {face, even};
}

std::string dropDuplicateFaces(TriangleMesh& mesh) {
  std::map<Face, int> sense;  // how many more run the one way round than the other
  for (const Face& face : mesh.faces) {
    const auto [corners, even] = sortedCorners(face);
    sense[corners] += even ? 1 : -1;
  }
  std::vector<char> drop;
  for (const Face& face : mesh.faces) {
    const auto [corners, even] = sortedCorners(face);
    int& wanted = sense[corners];
    const bool keep = even ? wanted > 0 : wanted < 0;
    drop.push_back(!keep);
    if (keep) wanted = 0;  // the first of them stays
  }
  const std::size_t count = dropFaces(mesh, drop);
  return count > 0 ? counted(count, "triangle") : "";
}

std::string keepLargestShell(TriangleMesh& mesh) {
  const std::vector<int> shells = shellsOf(mesh);
  if (shells.empty()) return "";
  std::vector<double> areas(static_cast<std::size_t>(*std::max_element(shells.begin(), shells.end())) + 1, 0);
  for (std::size_t f = 0; f < shells.size(); ++f) {
    const auto [a, b, c] = cornersOf(mesh, mesh.faces[f]);
    areas[static_cast<std::size_t>(shells[f])] += Vec3(b - a).cross(Vec3(c - a)).norm();
  }
  const auto largest = std::max_element(areas.begin(), areas.end()) - areas.begin();
  std::vector<char> drop;
  for (const int shell : shells) drop.push_back(shell != largest);
  const std::size_t count = dropFaces(mesh, drop);
  return count > 0 ? counted(areas.size() - 1, "shell") + " of " + counted(count, "triangle") : "";
}

std::string dropUnreferenced(TriangleMesh& mesh) {
  const std::size_t count = compact(mesh, usedVertices(mesh));
  return count == 0 ? "" : counted(count, "vertex", "vertices");
}

std::string orient(TriangleMesh& mesh) {
  const std::size_t count = orientConsistently(mesh);
  return count > 0 ? counted(count, "triangle") + " turned" : "";
}

/// Boundary loops, as a cap runs around them: against the triangles beside it. Only those in which each
/// vertex has one way on.
std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh) {
  std::map<int, std::vector<int>> next;
  forEachEdge(edgeUses(mesh.faces), [&](auto first, auto last) {
    if (last - first == 1)
      next[first->forward ? first->high : first->low].push_back(first->forward ? first->low : first->high);
  });
  std::vector<std::vector<int>> loops;
  std::map<int, bool> seen;
  for (const auto& [start, unused] : next) {
    std::vector<int> loop;
    int at = start;
    while (!seen[at] && next.contains(at) && next[at].size() == 1) {
      seen[at] = true;
      loop.push_back(at);
      at = next[at].front();
    }
    if (loop.size() >= 3 && at == start) loops.push_back(std::move(loop));
  }
  return loops;
}

std::string capHoles(TriangleMesh& mesh) {
  std::size_t edges = 0;
  const std::vector<std::vector<int>> loops = boundaryLoops(mesh);
  for (const std::vector<int>& loop : loops) {
    edges += loop.size();
    if (loop.size() == 3) {
      mesh.faces.push_back({loop[0], loop[1], loop[2]});
      continue;
    }
    Vec3 sum = Vec3::Zero();
    for (const int v : loop) sum += mesh.vertices_m[static_cast<std::size_t>(v)];
    const int middle = static_cast<int>(mesh.vertices_m.size());
    mesh.vertices_m.emplace_back(sum / static_cast<double>(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i)
      mesh.faces.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
  }
  return edges > 0 ? counted(loops.size(), "hole") + " of " + counted(edges, "edge") : "";
}

}  // namespace

std::vector<std::string> repairMesh(TriangleMesh& mesh, const std::vector<MeshRepair>& repairs) {
  using Step = std::string (*)(TriangleMesh&);
  constexpr std::array<std::pair<MeshRepair, Step>, 6> steps{
      {{MeshRepair::drop_degenerate, &dropDegenerate},
       {MeshRepair::drop_duplicate_faces, &dropDuplicateFaces},
       {MeshRepair::keep_largest_shell, &keepLargestShell},
       {MeshRepair::drop_unreferenced, &dropUnreferenced},
       {MeshRepair::orient, &orient},
       {MeshRepair::cap_holes, &capHoles}}};
  const auto asked = [&](MeshRepair repair) {
    return std::find(repairs.begin(), repairs.end(), repair) != repairs.end();
  };
  std::vector<std::string> done;
  for (const auto& [repair, step] : steps) {
    if (!asked(repair)) continue;
    const std::string change = step(mesh);
    if (!change.empty()) done.push_back(nameIn(catalog().mesh_repairs, repair) + ": " + change);
  }
  // Only now what is closed is known.
  const std::size_t turned = asked(MeshRepair::orient) ? turnOutward(mesh) : 0;
  if (turned > 0) done.push_back("orient: " + counted(turned, "closed piece") + " turned");
  return done;
}

}  // namespace fissure
