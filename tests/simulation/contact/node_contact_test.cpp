#include "contact/node_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "contact/grid_nodes.h"
#include "mesh/primitives.h"

namespace fissure::node_contact_test {

namespace {

constexpr double kMargin_m = 0.0005;

/// Tissue: cubes of 60 mm, finely triangulated would not matter: their faces stay flat. One box tool of 20 x
/// thickness x 10 mm with 3 x 3 nodes on its large faces, which are the upper (+y) and the lower (-y) one.
class NodeContactTest : public testing::Test {
 protected:
  void SetUp() override { addCube(Vec3::Zero()); }

  void addCube(const Vec3& middle_m) {
    TriangleMesh cube = makeBox({0.06, 0.06, 0.06});
    for (Vec3& v : cube.vertices_m) v += middle_m;
    scene.bodies.push_back(
        {.name = "cube", .rest = cube, .first_vertex = scene.vertexCount(), .first_face = scene.faceCount()});
  }

  void build(double thickness_m, NodeContactSettings settings = {}) {
    thickness_m_ = thickness_m;
    scene.tools = {{.name = "blade",
                    .surface = {},
                    .box_size_m = std::nullopt,
                    .nodes = makeGridNodes({0.02, thickness_m, 0.01}, {3, 3}),
                    .first_node = 0}};
    settings.margins_m.assign(scene.bodies.size(), kMargin_m);
    contact.emplace(scene, settings);
    for (const SceneBody& body : scene.bodies) {
      positions.insert(positions.end(), body.rest.vertices_m.begin(), body.rest.vertices_m.end());
    }
    tissue_before = positions;
    inverse_masses.assign(positions.size(), 10.0);
    patch.resize(scene.vertexCount(), scene.faceCount(), 1);
  }

  /// The blade's middle moves to height y (from where it was) in a step of 1 ms.
  void moveTo(double y, double x = 0) {
    before = now;
    now = {{.pose = {.position_m = Vec3(x, y, 0), .orientation = Quat::Identity()}}};
    if (before.empty()) before = now;
    contact->step({.positions_m = positions,
                   .before_m = tissue_before,
                   .tools_before = before,
                   .tools_now = now,
                   .dt_s = 0.001},
                  inverse_masses, outcome, patch);
    tissue_before = positions;
  }

  int countOf(NodeState kind, int from, int to) const {
    return static_cast<int>(
        std::count(outcome.node_states.begin() + from, outcome.node_states.begin() + to, kind));
  }
  int upper(NodeState kind) const { return countOf(kind, 0, 9); }
  int lower(NodeState kind) const { return countOf(kind, 9, 18); }

  Scene scene;
  std::optional<NodeContact> contact;
  std::vector<Vec3> positions, tissue_before;
  std::vector<double> inverse_masses;
  std::vector<ToolState> before, now;
  ContactOutcome outcome;
  ContactPatch patch;
  double thickness_m_ = 0;
};

TEST_F(NodeContactTest, ABladeAboveTheTissueMeetsNothing) {
  build(0.002);
  moveTo(0.030 + kMargin_m + 0.001 + 1e-6);  // lower face a margin and 1 um above the top
  EXPECT_EQ(outcome.candidate_count, 0);
  EXPECT_EQ(outcome.contact_count, 0);
  EXPECT_EQ(upper(NodeState::free) + lower(NodeState::free), 18);
  EXPECT_EQ(outcome.reaction_on_tool_N, Vec3::Zero());
}

TEST_F(NodeContactTest, TheLowerFacePushesTheTopDownToTheMargin) {
  build(0.002);
  moveTo(0.035);
  moveTo(0.030);  // lower face at 0.029: 1 mm deep
  EXPECT_EQ(lower(NodeState::feasible), 9);
  EXPECT_EQ(outcome.infeasible_count, 0);
  // Every hit point ends at least a margin in front of its node: below y = 0.029 - margin.
  for (const Vec3& p : positions) {
    if (p.y() > 0) {
      EXPECT_LE(p.y(), 0.030 + 1e-12);
    }
  }
  Vec3 moved = Vec3::Zero();
  for (std::size_t i = 0; i < positions.size(); ++i)
    moved += (positions[i] - scene.bodies[0].rest.vertices_m[i]) / 10;
  EXPECT_LT(moved.y(), 0);
  EXPECT_NEAR((outcome.reaction_on_tool_N + moved / 1e-6).norm(), 0, 1e-9)
      << "reaction: minus the tissue's m dx / dt^2";
  EXPECT_GT(outcome.reaction_on_tool_N.y(), 0);
}

TEST_F(NodeContactTest, ThinBladeDeepInside_OnlyTheLeadingSideActs) {
  // From above to 10 mm deep in one step: the lower face finds the top, 10 mm behind it; the upper face finds
  // the bottom of the cube through the tool, 51 mm behind it.
  build(0.002);
  moveTo(0.040);
  moveTo(0.021);  // faces at 0.020 and 0.022
  EXPECT_EQ(outcome.candidate_count, 18);
  EXPECT_EQ(lower(NodeState::feasible), 9);
  EXPECT_EQ(upper(NodeState::infeasible), 9);
}

// From 10 mm above the cube to 10 mm below it in one step: behind the blade there is no tissue that it is in.
TEST_F(NodeContactTest, ABladeThatJumpsRightThroughStillFindsTheSurfaceItWentInThrough) {
  build(0.002);
  moveTo(0.040);
  moveTo(-0.040);
  EXPECT_EQ(lower(NodeState::feasible), 9);
  EXPECT_EQ(outcome.contact_count, 9);
  EXPECT_EQ(outcome.capped_count, 0) << "the step brought all of it";
  EXPECT_GT(outcome.reaction_on_tool_N.y(), 0);
  // Half-way between the ends of its diagonal the cube's top now lies in front of the node in the middle.
  double lowest = 1;
  for (int v = 0; v < 8; ++v) {
    for (int w = 0; w < v; ++w) {
      const Vec3 at_rest_m = scene.bodies[0].rest.vertices_m[v] + scene.bodies[0].rest.vertices_m[w];
      if (at_rest_m.isApprox(Vec3(0, 0.060, 0)))
        lowest = std::min(lowest, 0.5 * (positions[v] + positions[w]).y());
    }
  }
  EXPECT_LE(lowest, -0.041 - kMargin_m + 1e-6);
}

// The same seen from the blade: it rests, and the cube flies through it.
TEST_F(NodeContactTest, TissueThatJumpsThroughABladeAtRestIsFoundToo) {
  build(0.002);
  moveTo(0.040);
  for (Vec3& p : positions) p.y() += 0.080;
  moveTo(0.040);
  EXPECT_EQ(lower(NodeState::feasible), 9);
  EXPECT_EQ(outcome.contact_count, 9);
}

// Blade and cube together, 80 mm in a step, 10 mm apart: nothing met.
TEST_F(NodeContactTest, TravellingTogetherIsNoContact) {
  build(0.002);
  moveTo(0.040);
  for (Vec3& p : positions) p.y() -= 0.080;
  moveTo(-0.040);
  EXPECT_EQ(outcome.candidate_count, 0);
}

TEST_F(NodeContactTest, PassingBesideTheTissueInOneStepIsNoContact) {
  build(0.002);
  moveTo(0.040, 0.045);
  moveTo(-0.040, 0.045);  // 5 mm beside the cube
  EXPECT_EQ(outcome.candidate_count, 0);
}

TEST_F(NodeContactTest, WithoutAssociationBothSidesActAtOnce) {
  build(0.002, {.association = false});
  moveTo(0.040);
  moveTo(0.021);
  EXPECT_EQ(outcome.infeasible_count, 0);
  EXPECT_EQ(outcome.contact_count, 18);
}

TEST_F(NodeContactTest, TheSideThatHeldTheContactKeepsItWhenTheBladeTurnsBack) {
  build(0.002);
  inverse_masses.assign(positions.size(), 0.0);  // tissue that does not give way, so the blade stays deep
  moveTo(0.040);
  moveTo(0.0305);  // lower face first
  ASSERT_EQ(lower(NodeState::feasible), 9);
  moveTo(-0.010);  // now deeper than half: the upper face would be the shallower one
  EXPECT_EQ(lower(NodeState::infeasible), 0);
  EXPECT_EQ(upper(NodeState::infeasible), 9);
  moveTo(-0.005);  // moving back up: the upper face leads, but the lower one has held
  EXPECT_EQ(lower(NodeState::infeasible), 0);
  EXPECT_EQ(upper(NodeState::infeasible), 9);
}

TEST_F(NodeContactTest, AtRestInsideFromTheStartTheShallowerSideActs) {
  build(0.002, {.sweeps = 1, .max_displacement_m = 1e-6});
  moveTo(0.010);  // first step, no motion: 21 mm to the top, 41 mm to the bottom
  EXPECT_EQ(lower(NodeState::capped), 9);
  EXPECT_EQ(upper(NodeState::infeasible), 9);
}

TEST_F(NodeContactTest, OverlapThatTheStepDidNotBringIsCapped) {
  build(0.002, {.max_displacement_m = 0.001});
  moveTo(0.021);  // starts 10 mm deep
  EXPECT_EQ(outcome.capped_count, 9);
  double lowest_top = 1;
  for (const Vec3& p : positions) {
    if (p.y() > 0) lowest_top = std::min(lowest_top, p.y());
  }
  EXPECT_GT(lowest_top, 0.030 - 0.0035) << "a millimetre at the contact points, not 10";
  EXPECT_LT(lowest_top, 0.030 - 0.0005);
}

TEST_F(NodeContactTest, WhatTheStepBroughtIsNeverCapped) {
  build(0.002, {.sweeps = 200, .max_displacement_m = 0.001});
  moveTo(0.0311 + kMargin_m);
  moveTo(0.021);
  EXPECT_EQ(outcome.capped_count, 0);
  EXPECT_EQ(lower(NodeState::feasible), 9);
}

// A blade on edge, 1 mm deep in the ridge of a flat roof, which looks up more than aside: of the nodes at its
// rim only those that look down may push it; those of the large faces beside them would push half the roof
// aside.
TEST_F(NodeContactTest, WithNodesOnAllSidesTissueIsLeftToTheSideThatItFaces) {
  TriangleMesh& roof = scene.bodies[0].rest;
  roof = makeSphere(0.03, 0);
  for (Vec3& v : roof.vertices_m) v = v.cwiseProduct(Vec3(2, 1, 2));
  for (const int narrow_rows : {0, 2}) {
    positions.clear();
    now.clear();
    build(0.002);
    scene.tools[0].nodes = makeGridNodes({0.02, 0.01, 0.002}, {3, 3}, narrow_rows);
    contact.emplace(scene, NodeContactSettings{.margins_m = {kMargin_m}});
    moveTo(0.036);
    moveTo(0.034);
    std::set<std::pair<int, bool>> sides;  // axis of the acting nodes' normals, and whether along it
    for (std::size_t i = 0; i < outcome.node_states.size(); ++i) {
      if (outcome.node_states[i] != NodeState::feasible && outcome.node_states[i] != NodeState::capped)
        continue;
      int axis = 0;
      scene.tools[0].nodes.normals[i].cwiseAbs().maxCoeff(&axis);
      sides.insert({axis, scene.tools[0].nodes.normals[i][axis] > 0});
    }
    if (narrow_rows == 0) {
      EXPECT_EQ(sides, (std::set<std::pair<int, bool>>{{2, true}})) << "sideways";
    } else {
      EXPECT_EQ(sides, (std::set<std::pair<int, bool>>{{1, false}})) << "downwards";
    }
  }
}

TEST_F(NodeContactTest, TissueOnBothSidesOfABladeIsNoConflict) {
  // Two cubes with a gap of 2 mm, the blade (2 mm) in it, each touching by less than the margins: both faces
  // act, each on its cube.
  scene.bodies.clear();
  addCube(Vec3(0, 0.031, 0));
  addCube(Vec3(0, -0.031, 0));
  build(0.002);
  moveTo(0.0);
  EXPECT_EQ(upper(NodeState::feasible), 9);
  EXPECT_EQ(lower(NodeState::feasible), 9);
  EXPECT_EQ(outcome.infeasible_count, 0);
}

// The same press on a body that lives twice as fast: moved alike, but by four
// times less force, as it has twice the time for half the speed.
TEST_F(NodeContactTest, AReactionIsInItsBodysOwnTime) {
  for (const ContactResponse response : {ContactResponse::none, ContactResponse::momentum}) {
    std::vector<double> reactions_N;
    for (const double scale : {1.0, 2.0}) {
      positions.clear();
      now.clear();
      build(0.002, {.response = response, .time_scales = {scale}});
      moveTo(0.035);
      moveTo(0.030);
      reactions_N.push_back(outcome.reaction_on_tool_N.y());
    }
    EXPECT_GT(reactions_N[1], 0);
    EXPECT_DOUBLE_EQ(reactions_N[0], 4 * reactions_N[1]);
  }
}

TEST_F(NodeContactTest, CountsSweepsOverContactsAndPushesThatMoveTissue) {
  build(0.002, {.sweeps = 7});
  moveTo(0.040);
  EXPECT_EQ(contact->displacementCounts().sweeps, 0) << "nothing met";
  inverse_masses.assign(positions.size(), 0.0);
  moveTo(0.030);
  EXPECT_EQ(contact->displacementCounts().sweeps, 7);
  EXPECT_EQ(contact->displacementCounts().pushes, 0) << "fixed tissue";
  inverse_masses.assign(positions.size(), 10.0);
  moveTo(0.030);
  EXPECT_EQ(contact->displacementCounts().sweeps, 14);
  EXPECT_GE(contact->displacementCounts().pushes, 1);
  EXPECT_LE(contact->displacementCounts().pushes, 7 * 9) << "of nine contacts in seven sweeps";
}

TEST_F(NodeContactTest, AFixedVertexStaysAndTheOthersGiveWay) {
  build(0.002);
  inverse_masses[0] = 0;
  const Vec3 fixed = positions[0];
  moveTo(0.035);
  moveTo(0.028);
  EXPECT_EQ(positions[0], fixed);
}

TEST_F(NodeContactTest, ContactsNameTheirTrianglesVerticesAndNormals) {
  build(0.002);
  moveTo(0.035);
  moveTo(0.030);
  int faces = 0;
  for (const Vec3& normal : patch.tools[0].face_normals) {
    if (normal.isZero(0)) continue;
    ++faces;
    EXPECT_EQ(normal.normalized(), Vec3(0, -1, 0)) << "from the tool into the tissue";
  }
  EXPECT_EQ(faces, 2) << "the two triangles of the cube's top";
  EXPECT_EQ(std::accumulate(patch.vertex_contact.begin(), patch.vertex_contact.end(), 0), 4);
}

/// A plate of 80 x 10 x 80 mm with contacts of vertices and edges, in a cube whose corners it covers.
class PlateInACube : public NodeContactTest {
 protected:
  void build(bool vertex_contacts) {
    NodeContactTest::build(0.010,
                           {.vertex_contacts = vertex_contacts, .response = ContactResponse::momentum});
    scene.tools[0].box_size_m = Vec3(0.08, 0.010, 0.08);
    scene.tools[0].nodes = makeGridNodes(*scene.tools[0].box_size_m, {9, 9});
    contact.emplace(scene, NodeContactSettings{.vertex_contacts = vertex_contacts,
                                               .response = ContactResponse::momentum,
                                               .margins_m = {kMargin_m}});
    positions = scene.bodies[0].rest.vertices_m;
  }
  /// The largest way of a vertex in a step with the plate's middle at height y.
  double wayIn(double y) {
    const std::vector<Vec3> start = positions;
    moveTo(y);
    double way_m = 0;
    for (std::size_t v = 0; v < start.size(); ++v) way_m = std::max(way_m, (positions[v] - start[v]).norm());
    return way_m;
  }
};

// Its upper face is coplanar with the top of the cube: the corners there are on it, and its nodes push the
// top down past them. 5 mm a step are the limit at a node; the corner of a triangle may go further than it.
TEST_F(PlateInACube, IsPushedFreeByItsNodesAloneAndThrowsNothing) {
  build(true);
  const double free_y = 0.025;
  int steps = 0;
  do {
    EXPECT_LE(wayIn(free_y), 0.0075) << "step " << steps;
    EXPECT_EQ(outcome.contact_count, outcome.candidate_count - outcome.infeasible_count) << "nodes alone";
  } while (outcome.capped_count > 0 && ++steps < 10);
  EXPECT_EQ(steps, 2) << "10 mm and a margin";
  for (const Vec3& p : positions) EXPECT_LE(p.y(), 0.020 - kMargin_m + 1e-6);
}

// Once it was free of tissue, it is a tool like any other.
TEST_F(PlateInACube, HoldsVerticesOnceItWasFree) {
  build(true);
  moveTo(0.025);
  moveTo(0.1);
  EXPECT_EQ(outcome.contact_count, 0);
  for (Vec3& p : positions) p.y() = p.y() > 0 ? 0.0945 : 0.03;  // the top within the margin of its lower face
  moveTo(0.1);
  EXPECT_EQ(outcome.contact_count, outcome.candidate_count + 4) << "the corners, besides the nodes";
}

// Association that is not mutual: node 0's partner is 1, node 1's partner is 2. All three have candidates
// that overlap. 0 leads most, so 1 is excluded by 0; 2 must not be excluded by the excluded 1.
TEST(NodeContactVetoes, OnlyAnActingNodeExcludesOthers) {
  Scene scene;
  scene.bodies.push_back({.name = "cube", .rest = makeBox({0.06, 0.06, 0.06})});
  ToolNodes nodes;
  nodes.positions_m = {Vec3(0, -0.001, 0), Vec3(0.001, 0.001, 0), Vec3(0.002, -0.001, 0.001)};
  nodes.normals = {-Vec3::UnitY(), Vec3::UnitY(), -Vec3::UnitY()};
  nodes.partners = {1, 2, -1};
  nodes.thicknesses_m = {0.002, 0.002, std::numeric_limits<double>::infinity()};
  scene.tools.push_back(
      {.name = "tool", .surface = {}, .box_size_m = std::nullopt, .nodes = nodes, .first_node = 0});
  NodeContact contact(scene, {.margins_m = {kMargin_m}});
  std::vector<Vec3> positions = scene.bodies[0].rest.vertices_m;
  const std::vector<double> inverse_masses(positions.size(), 10.0);
  ContactOutcome outcome;
  ContactPatch patch;
  patch.resize(scene.vertexCount(), scene.faceCount(), 1);
  const std::vector<ToolState> above = {{.pose = {.position_m = Vec3(0, 0.04, 0)}}};
  const std::vector<ToolState> inside = {{.pose = {.position_m = Vec3(0, 0.02, 0)}}};
  contact.step({.positions_m = positions,
                .before_m = scene.bodies[0].rest.vertices_m,
                .tools_before = above,
                .tools_now = inside,
                .dt_s = 0.001},
               inverse_masses, outcome, patch);
  ASSERT_EQ(outcome.candidate_count, 3);
  EXPECT_EQ(outcome.node_states[0], NodeState::feasible);
  EXPECT_EQ(outcome.node_states[1], NodeState::infeasible);
  EXPECT_EQ(outcome.node_states[2], NodeState::feasible);
}

}  // namespace
}  // namespace fissure::node_contact_test
