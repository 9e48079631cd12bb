// Each repair on a small mesh that needs it; none without being asked.
#include "mesh/repair.h"

#include <gtest/gtest.h>

#include "defect_lines.h"
#include "mesh/check.h"
#include "mesh/primitives.h"
#include "mesh/subdivide.h"
#include "mesh/triangle.h"
#include "scenario/catalog.h"

namespace fissure::repair_test {

namespace {

using Lines = std::vector<std::string>;

TriangleMesh ball() {
  return makeSphere(0.03, 2);
}

void append(TriangleMesh& mesh, const TriangleMesh& other, const Vec3& by) {
  const int first = static_cast<int>(mesh.vertices_m.size());
  for (const Vec3& v : other.vertices_m) mesh.vertices_m.push_back(v + by);
  for (const auto& [a, b, c] : other.faces) mesh.faces.push_back({first + a, first + b, first + c});
}

void reverse(TriangleMesh& mesh, std::size_t first, std::size_t last) {
  for (std::size_t f = first; f < last; ++f) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
}

std::vector<MeshRepair> allRepairs() {
  std::vector<MeshRepair> repairs;
  for (std::size_t i = 0; i < catalog().mesh_repairs.size(); ++i)
    repairs.push_back(static_cast<MeshRepair>(i));
  return repairs;
}

TEST(Repair, LeavesAGoodMeshAlone) {
  TriangleMesh mesh = ball();
  EXPECT_EQ(repairMesh(mesh, allRepairs()), Lines{});
  EXPECT_EQ(mesh.faces, ball().faces);
  EXPECT_EQ(mesh.vertices_m, ball().vertices_m);
}

TEST(Repair, DoesNothingUnasked) {
  TriangleMesh mesh = ball();
  mesh.faces.pop_back();
  reverse(mesh, 3, 5);
  mesh.vertices_m.push_back(Vec3::Zero());
  const TriangleMesh before = mesh;
  EXPECT_EQ(repairMesh(mesh, {}), Lines{});
  EXPECT_EQ(mesh.faces, before.faces);
  EXPECT_EQ(mesh.vertices_m, before.vertices_m);
}

TEST(Repair, DropsDegenerateTriangles) {
  TriangleMesh mesh = ball();
  mesh.faces.push_back({1, 1, 2});
  mesh.vertices_m.push_back({1, 0, 0});  // three on a line, far from all others: they go with their triangle
  mesh.vertices_m.push_back({2, 0, 0});
  mesh.vertices_m.push_back({3, 0, 0});
  const int last = static_cast<int>(mesh.vertices_m.size()) - 1;
  mesh.faces.push_back({last - 2, last - 1, last});
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::drop_degenerate}), Lines{"drop_degenerate: 2 triangles"});
  EXPECT_EQ(mesh.faces, ball().faces);
  EXPECT_EQ(mesh.vertices_m, ball().vertices_m);
}

TEST(Repair, OfDuplicateFacesOneStaysAndOppositeOnesCancel) {
  TriangleMesh mesh = ball();
  const auto [a, b, c] = mesh.faces[7];
  mesh.faces.push_back({c, a, b});  // again
  mesh.faces.push_back({b, c, a});
  const auto [d, e, f] = mesh.faces[20];
  mesh.vertices_m.push_back(Vec3(0.1, 0, 0));  // a fin glued to an edge, seen from both sides
  const int tip = static_cast<int>(mesh.vertices_m.size()) - 1;
  mesh.faces.push_back({d, e, tip});
  mesh.faces.push_back({e, d, tip});
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::drop_duplicate_faces}), Lines{"drop_duplicate_faces: 4 triangles"});
  EXPECT_EQ(mesh.faces, ball().faces);
  EXPECT_EQ(mesh.vertices_m, ball().vertices_m);
}

TEST(Repair, KeepsTheLargestShell) {
  TriangleMesh mesh = makeBox({0.01, 0.01, 0.01});
  append(mesh, ball(), Vec3(0.1, 0, 0));
  append(mesh, makeBox({0.001, 0.001, 0.001}), Vec3(0.2, 0, 0));
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::keep_largest_shell}),
            Lines{"keep_largest_shell: 2 shells of 24 triangles"});
  EXPECT_EQ(mesh.faces, ball().faces);
  EXPECT_EQ(findDefects(mesh), Lines{});
}

TEST(Repair, DropsUnreferencedVertices) {
  TriangleMesh mesh = ball();
  mesh.vertices_m.insert(mesh.vertices_m.begin() + 4, Vec3(1, 1, 1));
  for (Face& face : mesh.faces)
    for (int& v : face) v += v >= 4;
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::drop_unreferenced}), Lines{"drop_unreferenced: 1 vertex"});
  EXPECT_EQ(mesh.faces, ball().faces);
}

TEST(Repair, OrientsTheFewerTriangles) {
  TriangleMesh mesh = ball();
  reverse(mesh, 10, 25);
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::orient}), Lines{"orient: 15 triangles turned"});
  EXPECT_EQ(findDefects(mesh), Lines{});
}

TEST(Repair, TurnsWhatIsInsideOut) {
  TriangleMesh mesh = ball();
  reverse(mesh, 0, mesh.faces.size());
  reverse(mesh, 0, 3);
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::orient}),
            (Lines{"orient: 3 triangles turned", "orient: 1 closed piece turned"}));
  EXPECT_EQ(findDefects(mesh), Lines{});
}

TEST(Repair, ACavityStaysInward) {
  TriangleMesh mesh = ball();  // 128 triangles
  append(mesh, makeSphere(0.01, 1), Vec3::Zero());
  reverse(mesh, 128, mesh.faces.size());
  EXPECT_EQ(findDefects(mesh), Lines{}) << "a hollow ball";
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::orient}), Lines{});
  // The same shell beside the ball is inside out, though the volume of both is positive.
  TriangleMesh beside = ball();
  append(beside, makeSphere(0.01, 1), Vec3(0.1, 0, 0));
  reverse(beside, 128, beside.faces.size());
  EXPECT_EQ(findDefects(beside), Lines{"1 of 2 shells inside out (and no cavity of another one)"});
  EXPECT_EQ(repairMesh(beside, {MeshRepair::orient}), Lines{"orient: 1 closed piece turned"});
  EXPECT_EQ(findDefects(beside), Lines{});
}

TEST(Repair, AMoebiusStripCannotBeOriented) {
  // Five squares, the last joined to the first upside down.
  TriangleMesh strip;
  for (int i = 0; i < 5; ++i) {
    const double angle = 1.2566370614359172 * i;
    for (const double side : {-1.0, 1.0})
      strip.vertices_m.emplace_back((3 + side * std::cos(angle / 2)) * std::cos(angle),
                                    (3 + side * std::cos(angle / 2)) * std::sin(angle),
                                    side * std::sin(angle / 2));
  }
  for (int i = 0; i < 5; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i < 4 ? 2 * i + 3 : 0, d = i < 4 ? 2 * i + 2 : 1;
    strip.faces.push_back({a, b, c});
    strip.faces.push_back({a, c, d});
  }
  const TriangleMesh before = strip;
  EXPECT_EQ(repairMesh(strip, {MeshRepair::orient}), Lines{});
  EXPECT_EQ(strip.faces, before.faces);
}

TEST(Repair, CapsHoles) {
  // A box without its lid (four edges) and with a triangle missing in the floor.
  TriangleMesh mesh = makeBox({0.02, 0.03, 0.04});
  const double volume_m3 = signedVolume_m3(mesh);
  std::vector<Face> kept;
  for (const Face& face : mesh.faces) {
    const auto corners = cornersOf(mesh, face);
    const bool lid = corners[0].y() > 0 && corners[1].y() > 0 && corners[2].y() > 0;
    if (!lid) kept.push_back(face);
  }
  ASSERT_EQ(kept.size(), 10u);
  const auto floor = [&](const Face& face) {
    const auto corners = cornersOf(mesh, face);
    return corners[0].y() < 0 && corners[1].y() < 0 && corners[2].y() < 0;
  };
  kept.erase(std::find_if(kept.begin(), kept.end(), floor));
  mesh.faces = kept;
  EXPECT_EQ(findDefects(mesh), Lines{"7 boundary edges (the surface is open)"});
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::cap_holes}), Lines{"cap_holes: 2 holes of 7 edges"});
  EXPECT_EQ(findDefects(mesh), Lines{});
  EXPECT_EQ(mesh.faces.size(), 9u + 1 + 4);
  EXPECT_NEAR(signedVolume_m3(mesh), volume_m3, 1e-18);
}

TEST(Repair, CapsAMisorientedMeshOnlyOnceItIsOriented) {
  TriangleMesh mesh = ball();
  mesh.faces.pop_back();
  reverse(mesh, 0, mesh.faces.size());  // all, so that it is consistent and inward
  reverse(mesh, 0, 40);
  TriangleMesh capped = mesh;
  repairMesh(capped, {MeshRepair::cap_holes, MeshRepair::orient});  // in the catalog's order, not in this one
  EXPECT_EQ(findDefects(capped), Lines{});
  EXPECT_NEAR(signedVolume_m3(capped), signedVolume_m3(ball()), 1e-18);
}

TEST(Repair, LoopsThatTouchStayOpen) {
  // Two triangles that share a vertex are missing: that vertex has two ways on.
  TriangleMesh mesh = ball();
  const Face gone = mesh.faces[0];
  const auto touches = [&](const Face& face) {
    int shared = 0;
    for (const int v : face) shared += std::count(gone.begin(), gone.end(), v) > 0;
    return shared == 1;
  };
  mesh.faces.erase(std::find_if(mesh.faces.begin() + 1, mesh.faces.end(), touches));
  mesh.faces.erase(mesh.faces.begin());
  EXPECT_EQ(repairMesh(mesh, {MeshRepair::cap_holes}), Lines{});
  EXPECT_EQ(findDefects(mesh), Lines{"6 boundary edges (the surface is open)"});
}

double longestEdge(const TriangleMesh& mesh) {
  double longest = 0;
  for (const Face& face : mesh.faces) {
    const auto corners = cornersOf(mesh, face);
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (corners[k] - corners[(k + 1) % 3]).norm());
  }
  return longest;
}

TEST(Subdivide, KeepsTheSurfaceWhereItIs) {
  for (const TriangleMesh& coarse : {ball(), makeBox({0.08, 0.0005, 0.02})})
    for (const double max_edge_m : {0.02, 0.01, 0.0037}) {
      TriangleMesh fine = coarse;
      ASSERT_TRUE(subdivide(fine, max_edge_m, 1 << 20));
      EXPECT_LE(longestEdge(fine), max_edge_m);
      EXPECT_EQ(findDefects(fine), Lines{});
      EXPECT_NEAR(signedVolume_m3(fine) / signedVolume_m3(coarse), 1, 1e-12);
    }
}

TEST(Subdivide, LeavesShortEdgesAlone) {
  TriangleMesh mesh = ball();
  ASSERT_TRUE(subdivide(mesh, 1.0001 * longestEdge(mesh), 128));
  EXPECT_EQ(mesh.faces, ball().faces);
}

TEST(Subdivide, StopsAtALimit) {
  TriangleMesh mesh = ball();
  EXPECT_FALSE(subdivide(mesh, 1e-6, 10000));
}

}  // namespace
}  // namespace fissure::repair_test
