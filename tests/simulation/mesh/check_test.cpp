#include "mesh/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "defect_lines.h"
#include "mesh/primitives.h"
#include "mesh/triangle.h"
#include "mesh/weld.h"

namespace fissure::check_test {

namespace {

using Lines = std::vector<std::string>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TriangleMesh sphere() {
  return makeSphere(0.03, 2);
}

TEST(FindDefects, CountsBoundaryEdges) {
  TriangleMesh mesh = sphere();
  mesh.faces.pop_back();
  EXPECT_EQ(findDefects(mesh), Lines{"3 boundary edges (the surface is open)"});
}

// Each triangle with corners of its own, each coordinate written with seven digits.
TEST(FindDefects, SaysWhereWeldingMayCloseTheSurface) {
  TriangleMesh mesh, whole = sphere();
  for (const Face& face : whole.faces) {
    const int first = static_cast<int>(mesh.vertices_m.size());
    for (const Vec3& corner : cornersOf(whole, face)) {
      const double noise = 1e-9 * static_cast<double>(mesh.vertices_m.size() % 7);
      mesh.vertices_m.emplace_back(corner + Vec3(noise, -noise, noise));
    }
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  const Lines lines = findDefects(mesh);
  EXPECT_EQ(lines.back(),
            "384 boundary edges (the surface is open, but 384 of its 384 rim vertices nearly coincide with "
            "another: weld_tolerance_m: 2e-08 may close it)");
  weldVertices(mesh, 2e-8);
  EXPECT_EQ(findDefects(mesh), Lines{});
}

TEST(FindDefects, CountsOneInTheSingular) {
  // A box with a spare vertex.
  TriangleMesh mesh = makeBox({1, 1, 1});
  mesh.vertices_m.push_back({5, 5, 5});
  EXPECT_EQ(findDefects(mesh), Lines{"1 unreferenced vertex (part of no triangle)"});
}

TEST(FindDefects, CountsNonManifoldEdges) {
  // A fin glued on one edge of a box: that edge has three triangles, the fin two free edges.
  TriangleMesh mesh = makeBox({1, 1, 1});
  mesh.vertices_m.push_back({3, 3, 3});
  mesh.faces.push_back({0, 4, 8});
  EXPECT_EQ(findDefects(mesh),
            (Lines{"2 boundary edges (the surface is open)",
                   "1 non-manifold edge (shared by more than two triangles)",
                   "1 inconsistently oriented edge (its triangles disagree about the outside)"}));
}

TEST(FindDefects, CountsDuplicateFacesAndTheirEdges) {
  TriangleMesh mesh = sphere();
  const auto [a, b, c] = mesh.faces[7];
  mesh.faces.push_back({b, c, a});
  EXPECT_EQ(findDefects(mesh),
            (Lines{"1 duplicate face (the same three corners as another one)",
                   "3 non-manifold edges (shared by more than two triangles)",
                   "3 inconsistently oriented edges (its triangles disagree about the outside)"}));
}

TEST(FindDefects, CountsInconsistentlyOrientedEdges) {
  TriangleMesh mesh = sphere();
  std::swap(mesh.faces[5][0], mesh.faces[5][1]);
  EXPECT_EQ(findDefects(mesh),
            Lines{"3 inconsistently oriented edges (its triangles disagree about the outside)"});
}

TEST(FindDefects, FindsASurfaceThatIsInsideOut) {
  TriangleMesh mesh = makeBox({1, 2, 3});
  for (Face& face : mesh.faces) std::swap(face[0], face[1]);
  EXPECT_EQ(findDefects(mesh), Lines{"inside out (its volume is -6 m^3: reverse all triangles)"});
  // Also when another, harmless, thing is wrong.
  mesh.vertices_m.insert(mesh.vertices_m.end(), {kNan, 0, 0});
  EXPECT_EQ(findDefects(mesh).size(), 3u);
  EXPECT_EQ(findDefects(mesh).back(), "inside out (its volume is -6 m^3: reverse all triangles)");
}

TEST(FindDefects, FindsAClosedSheetWithoutVolume) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  EXPECT_EQ(findDefects(mesh), (Lines{"1 duplicate face (the same three corners as another one)",
                                      "no enclosed volume (the surface is a folded sheet)"}));
}

TEST(FindDefects, CountsDegenerateTriangles) {
  // A vertex in the middle of an edge of a box, joined to it by a flat triangle: closed, but one face has no
  // normal.
  TriangleMesh mesh = makeBox({2, 2, 2});
  mesh.vertices_m.push_back({-1, -1, 0});  // between vertices 0 (z = -1) and 4 (z = 1)
  const int middle = 8;
  mesh.faces[0] = {0, middle, 6};  // was 0 4 6, split at the edge 0-4 ...
  mesh.faces.push_back({middle, 4, 6});
  mesh.faces.push_back({0, 4, middle});  // ... with the flat one between it and the old neighbour across 0-4
  EXPECT_EQ(findDefects(mesh), Lines{"1 degenerate triangle (without area, and so without a normal)"});
  // A face that names a vertex twice is left out of the edges.
  TriangleMesh other = makeBox({2, 2, 2});
  other.faces.push_back({1, 1, 2});
  other.faces.push_back({3, 4, 3});
  EXPECT_EQ(findDefects(other), Lines{"2 degenerate triangles (without area, and so without a normal)"});
}

TEST(FindDefects, AcceptsThinTrianglesThatHaveANormal) {
  // A blade 0.02 mm thick and 80 mm long: aspect ratio 4,000.
  EXPECT_EQ(findDefects(makeBox({0.08, 0.00002, 0.08})), Lines{});
}

TEST(FindDefects, CountsDuplicatePositions) {
  // Each triangle of the octahedron brings its own three corners, as an STL file does: 24 for 6 places; all
  // edges free.
  const TriangleMesh octahedron = makeSphere(1, 0);
  TriangleMesh soup;
  for (const Face& face : octahedron.faces) {
    const int first = static_cast<int>(soup.vertices_m.size());
    for (const int v : face) soup.vertices_m.push_back(octahedron.vertices_m[static_cast<std::size_t>(v)]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(findDefects(soup), (Lines{"18 duplicate vertices (at the position of another one)",
                                      "24 boundary edges (the surface is open)"}));
}

TEST(FindDefects, TakesMinusZeroForZero) {
  TriangleMesh mesh = makeSphere(1, 0);
  mesh.vertices_m.push_back({1, -0.0, -0.0});
  EXPECT_EQ(findDefects(mesh), (Lines{"1 unreferenced vertex (part of no triangle)",
                                      "1 duplicate vertex (at the position of another one)"}));
}

TEST(FindDefects, CountsIndicesOutOfRange) {
  TriangleMesh mesh = makeBox({1, 1, 1});
  mesh.faces[0] = {0, 4, 8};
  mesh.faces[1] = {-1, 6, 2};
  const Lines lines = findDefects(mesh);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "2 triangles with an index out of range (there are 8 vertices, counted from 0)");
  EXPECT_EQ(lines[1], "4 boundary edges (the surface is open)");  // of the missing quad
}

TEST(FindDefects, CountsNonFiniteVertices) {
  TriangleMesh mesh = sphere();
  mesh.vertices_m[10].y() = kNan;
  mesh.vertices_m[20].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(findDefects(mesh), Lines{"2 non-finite vertices (a coordinate is infinite or not a number)"});
}

TEST(FindDefects, SaysThatAMeshIsEmpty) {
  EXPECT_EQ(findDefects({}), Lines{"no triangles (the surface is empty)"});
}

TEST(FindDefects, AcceptsSeveralShells) {
  TriangleMesh mesh = makeBox({1, 1, 1});
  const TriangleMesh other = makeBox({1, 1, 1});
  for (const Vec3& vertex : other.vertices_m) mesh.vertices_m.push_back(vertex + Vec3(3, 0, 0));
  for (const auto& [a, b, c] : other.faces) mesh.faces.push_back({a + 8, b + 8, c + 8});
  EXPECT_EQ(findDefects(mesh), Lines{});
}

TEST(SignedVolume, DoesNotDependOnWhereTheBodyIs) {
  // A 2 mm cube 1 km away: about the origin the terms would be 1e9 m^3 times larger than their sum.
  TriangleMesh mesh = makeBox({0.002, 0.002, 0.002});
  for (Vec3& vertex : mesh.vertices_m) vertex += Vec3(1000, 1000, 1000);
  EXPECT_NEAR(signedVolume_m3(mesh) / 8e-9, 1.0, 1e-9);
  EXPECT_EQ(signedVolume_m3({}), 0.0);
}

}  // namespace
}  // namespace fissure::check_test
