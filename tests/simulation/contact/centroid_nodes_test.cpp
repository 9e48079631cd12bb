#include "contact/centroid_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/node_contact.h"
#include "mesh/file_surface.h"
#include "mesh/primitives.h"
#include "mesh/subdivide.h"

namespace fissure::centroid_nodes_test {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The spatula of configs/meshes: 40 x 15 x 2 mm, bevelled to an edge of 0.02 mm.
TriangleMesh convexSpatula() {
  FileShape shape;
  shape.file = "convex_spatula.obj";
  shape.unit = LengthUnit::mm;
  return loadSurface(shape, FISSURE_SOURCE_DIR "/configs/meshes").mesh;
}

/// Every triangle has a node, and only the middle of triangles has.
constexpr CentroidNodeSettings kPaper{.pairing_limit = kInfinity, .rim_nodes = false};

/// Slow: the nearest triangle from whose inside the ray comes, each tried by solving for the plane's point.
std::pair<int, double> slowExit(const TriangleMesh& mesh, int from, const Vec3& start, const Vec3& way) {
  std::pair<int, double> nearest{-1, kInfinity};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 &a = mesh.vertices_m[mesh.faces[f][0]], &b = mesh.vertices_m[mesh.faces[f][1]],
               &c = mesh.vertices_m[mesh.faces[f][2]];
    if (static_cast<int>(f) == from || (b - a).cross(c - a).dot(way) <= 0) continue;
    Mat3 system;
    system << b - a, c - a, -way;
    const Vec3 solved = system.fullPivLu().solve(start - a);
    if (solved.x() < -1e-9 || solved.y() < -1e-9 || solved.x() + solved.y() > 1 + 1e-9) continue;
    if (solved.z() > 0 && solved.z() < nearest.second) nearest = {static_cast<int>(f), solved.z()};
  }
  return nearest;
}

TEST(CentroidNodes, PartnersAreWhereASlowRayLeavesTheTool) {
  const TriangleMesh mesh = convexSpatula();
  const ToolNodes nodes = makeCentroidNodes(mesh, kPaper);
  ASSERT_EQ(nodes.size(), static_cast<int>(mesh.faces.size()));
  int not_mutual = 0;
  for (int i = 0; i < nodes.size(); ++i) {
    const Face& face = mesh.faces[i];
    const Vec3 middle = (mesh.vertices_m[face[0]] + mesh.vertices_m[face[1]] + mesh.vertices_m[face[2]]) / 3;
    EXPECT_EQ(nodes.positions_m[i], middle);
    const auto [exit, distance_m] = slowExit(mesh, i, middle, -nodes.normals[i]);
    ASSERT_GE(exit, 0);
    EXPECT_NEAR(nodes.thicknesses_m[i], distance_m, 1e-9) << i;
    // On an edge either triangle is right.
    EXPECT_NEAR(
        slowExit({mesh.vertices_m, {mesh.faces[nodes.partners[i]]}}, -1, middle, -nodes.normals[i]).second,
        distance_m, 1e-9);
    not_mutual += nodes.partners[nodes.partners[i]] != i;
  }
  EXPECT_GT(not_mutual, 50) << "association of triangles is not mutual";
}

TEST(CentroidNodes, OfASphereFaceEachOtherThroughItsMiddle) {
  const ToolNodes nodes = makeCentroidNodes(makeSphere(0.004, 2));
  ASSERT_EQ(nodes.size(), 128) << "as thick everywhere: no limit and no rim matter";
  for (int i = 0; i < nodes.size(); ++i) {
    ASSERT_GE(nodes.partners[i], 0);
    const Vec3& across = nodes.positions_m[nodes.partners[i]];
    EXPECT_LT((nodes.positions_m[i] + across).norm(), 0.0012)
        << "a triangle across the middle, or next to it";
    EXPECT_NEAR(nodes.thicknesses_m[i], 2 * nodes.positions_m[i].norm(), 1e-4);
  }
}

// The paper's Fig. 2, left: pairs near the side edge a hundred times closer than the tool is thick. Right:
// rays of the triangles there run along the tool, to a wrong partner at the other end. The limit tells them
// apart; all true pairs, as close as they may be, stay.
TEST(CentroidNodes, TheLimitTakesRaysAlongTheToolAndNoneAcross) {
  const TriangleMesh mesh = convexSpatula();
  const ToolNodes all = makeCentroidNodes(mesh, kPaper);
  int along = 0;
  for (int i = 0; i < all.size(); ++i) along += all.thicknesses_m[i] > 0.01;
  EXPECT_EQ(along, 48) << "those of the band of the edge: 24 quadrangles";
  EXPECT_LT(*std::min_element(all.thicknesses_m.begin(), all.thicknesses_m.end()), 0.002 / 2);

  const ToolNodes limited = makeCentroidNodes(mesh, {.rim_nodes = false});
  EXPECT_EQ(limited.size(), all.size() - along);
  for (int i = 0; i < limited.size(); ++i) {
    EXPECT_GE(limited.partners[i], 0);
    EXPECT_LT(limited.thicknesses_m[i], 0.003) << i;
    EXPECT_GT(std::abs(limited.normals[i].y()), 0.5) << "none on the edge";
  }
  const ToolNodes kept = makeCentroidNodes(mesh, {.lone_nodes = true, .rim_nodes = false});
  EXPECT_EQ(kept.size(), all.size());
  EXPECT_EQ(std::count(kept.partners.begin(), kept.partners.end(), -1), along);
}

TEST(CentroidNodes, RimNodesStandWhereNodesEnd) {
  TriangleMesh box = makeBox({0.04, 0.002, 0.015});
  ASSERT_TRUE(subdivide(box, 0.005, 10000));
  const ToolNodes inner = makeCentroidNodes(box, {.rim_nodes = false});
  const ToolNodes nodes = makeCentroidNodes(box);
  ASSERT_GT(nodes.size(), inner.size());
  bool corner = false;
  for (int i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(nodes.normals[i].cwiseAbs(), Vec3(0, 1, 0)) << "the narrow faces have none";
    EXPECT_NEAR(nodes.thicknesses_m[i], 0.002, 1e-12);
    ASSERT_GE(nodes.partners[i], 0);
    EXPECT_EQ(nodes.normals[nodes.partners[i]], Vec3(-nodes.normals[i]));
    const Vec3 from_rim = Vec3(0.02, 0.001, 0.0075) - nodes.positions_m[i].cwiseAbs();
    EXPECT_GE(from_rim.minCoeff(), -1e-15);
    EXPECT_TRUE(i < inner.size() || std::min(from_rim.x(), from_rim.z()) < 1e-5);
    corner = corner || (from_rim.x() < 1e-5 && from_rim.z() < 1e-5);
  }
  EXPECT_TRUE(corner);
}

TEST(CentroidNodes, ATriangleWithoutAnAreaHasNone) {
  TriangleMesh box = makeBox({0.04, 0.002, 0.015});
  box.faces.push_back({0, 1, 1});
  EXPECT_EQ(makeCentroidNodes(box, kPaper).size(), 12);
}

/// The spatula deep in a cube of 60 mm, put there in the first step.
class SpatulaInACube : public testing::Test {
 protected:
  void build(const CentroidNodeSettings& nodes, std::optional<double> ray_length_m = {}) {
    scene.bodies = {{.name = "cube", .rest = makeBox({0.06, 0.06, 0.06})}};
    const TriangleMesh spatula = convexSpatula();
    scene.tools = {{.name = "spatula", .surface = spatula, .nodes = makeCentroidNodes(spatula, nodes)}};
    contact.emplace(scene, NodeContactSettings{.ray_length_m = ray_length_m, .margins_m = {0.0005}});
    positions = scene.bodies[0].rest.vertices_m;
    patch.resize(scene.vertexCount(), scene.faceCount(), 1);
    // It came down from above: the lower side leads.
    const std::vector<ToolState> before = {{.pose = {.position_m = Vec3(0, 0.026, 0)}}};
    const std::vector<ToolState> now = {{.pose = {.position_m = Vec3(0, 0.025, 0)}}};
    const std::vector<double> inverse_masses(positions.size(), 10.0);
    contact->step({.positions_m = positions,
                   .before_m = scene.bodies[0].rest.vertices_m,
                   .tools_before = before,
                   .tools_now = now,
                   .dt_s = 0.001},
                  inverse_masses, outcome, patch);
  }
  /// How many nodes that look so much upwards act.
  int acting(double least_y, double most_y) const {
    int count = 0;
    for (int i = 0; i < scene.tools[0].nodes.size(); ++i) {
      const double y = scene.tools[0].nodes.normals[i].y();
      const NodeState shown = outcome.node_states[i];
      count += y >= least_y && y <= most_y && (shown == NodeState::feasible || shown == NodeState::capped);
    }
    return count;
  }

  Scene scene;
  std::optional<NodeContact> contact;
  std::vector<Vec3> positions;
  ContactOutcome outcome;
  ContactPatch patch;
};

// Rays of the edge's nodes run along the spatula and leave the cube on its far side, 30 mm away: without a
// partner across, nothing vetoes them. A limit of pairing leaves them out, one of rays does not let them
// reach.
TEST_F(SpatulaInACube, EitherLimitKeepsTheEdgeFromPullingAtTheFarSide) {
  build({.lone_nodes = true, .rim_nodes = false});
  EXPECT_EQ(acting(-0.5, 0.5), 48);
  build({.rim_nodes = false});
  EXPECT_EQ(acting(-0.5, 0.5), 0);
  build({.lone_nodes = true, .rim_nodes = false}, 0.01);
  EXPECT_EQ(acting(-0.5, 0.5), 0);
}

TEST_F(SpatulaInACube, TheLowerSideExcludesTheUpperOne) {
  build({.rim_nodes = false});
  EXPECT_EQ(acting(-1, -0.5), 168) << "the lower side, all of it";
  EXPECT_EQ(acting(0.5, 1), 0) << "the upper side, whose rays leave through the bottom of the cube";
  EXPECT_EQ(std::count(outcome.node_states.begin(), outcome.node_states.end(), NodeState::infeasible), 144)
      << "24 look aslant, and their rays end in the cube";
}

}  // namespace
}  // namespace fissure::centroid_nodes_test
