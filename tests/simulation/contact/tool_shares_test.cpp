// Several tools on one body: which of them feels a triangle's force (contact/METHOD.md 12).
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "contact/grid_nodes.h"
#include "contact/node_contact.h"
#include "contact/triangle_forces.h"
#include "mesh/primitives.h"

namespace fissure::tool_shares_test {

namespace {

constexpr double kStiffness = 100;

/// A box 5 mm away from its rest, two tools, a linear law.
class ToolShares : public testing::Test {
 protected:
  ToolShares() {
    scene.bodies.push_back({.name = "box", .rest = makeBox({0.02, 0.02, 0.02})});
    scene.tools.resize(2);
    state.positions_m = scene.bodies[0].rest.vertices_m;
    for (Vec3& p : state.positions_m) p += Vec3(0, -0.005, 0);
    state.velocities_m_s.assign(state.positions_m.size(), Vec3::Zero());
    patch.resize(scene.vertexCount(), scene.faceCount(), 2);
    patch.clear();
  }
  void touch(int tool, int face, const Vec3& normal, double displacement_m) {
    patch.touchFace(tool, face, normal, displacement_m);
    for (const int vertex : scene.bodies[0].rest.faces[face])
      patch.touchVertex(tool, vertex, 1.0 / 3, normal, displacement_m);
  }
  void evaluate() {
    std::vector<TriangleLaw> laws;
    laws.push_back({ForceLaw(ForceModel::linear_elastic, {.k = kStiffness})});
    laws.push_back({ForceLaw(ForceModel::linear_elastic, {.k = 3 * kStiffness})});
    TriangleForces(scene, std::move(laws), 0.001, true).evaluate(patch, state);
  }
  const Vec3& force(std::size_t law, std::size_t tool) const { return state.tool_forces_N[2 * law + tool]; }

  Scene scene;
  State state;
  ContactPatch patch;
};

void expectNear(const Vec3& found, const Vec3& expected) {
  EXPECT_LE((found - expected).norm(), 1e-14) << found.transpose() << " instead of " << expected.transpose();
}

TEST_F(ToolShares, EachTriangleGoesToTheToolsOnItInProportionToTheirDisplacements) {
  touch(0, 0, -Vec3::UnitY(), 0.003);
  touch(1, 0, -Vec3::UnitY(), 0.001);
  evaluate();
  const double all_N = kStiffness * 0.005 * static_cast<double>(state.colliding_triangles.size());
  expectNear(force(0, 0), Vec3(0, 0.75 * all_N, 0));
  expectNear(force(0, 1), Vec3(0, 0.25 * all_N, 0));
  expectNear(force(1, 1), Vec3(0, 0.75 * all_N, 0));
}

TEST_F(ToolShares, TrianglesSumUpToTheToolsForces) {
  touch(0, 0, -Vec3::UnitY(), 0.003);
  touch(1, 4, Vec3::UnitX(), 0.001);
  evaluate();
  ASSERT_FALSE(state.colliding_triangles.empty());
  EXPECT_TRUE(std::is_sorted(state.colliding_triangles.begin(), state.colliding_triangles.end()));
  ASSERT_EQ(state.triangle_forces_N.size(), 2 * state.colliding_triangles.size());
  for (std::size_t law = 0; law < 2; ++law) {
    Vec3 sum_N = Vec3::Zero();
    for (std::size_t i = 0; i < state.colliding_triangles.size(); ++i)
      sum_N += state.triangle_forces_N[2 * i + law];
    EXPECT_GT(sum_N.norm(), 0.1);
    expectNear(sum_N, force(law, 0) + force(law, 1));
    for (std::size_t i = 0; i < state.colliding_triangles.size(); ++i) {
      const LawInput& input = state.law_inputs[2 * i + law];
      const double stiffness = (law == 0 ? 1 : 3) * kStiffness;
      expectNear(stiffness * input.deformation_m * input.direction, state.triangle_forces_N[2 * i + law]);
    }
  }
}

TEST_F(ToolShares, ATriangleWithoutOneOfItsOwnGoesByItsVertices) {
  // Both tools on opposite faces: what lies between carries vertices of one or both.
  int opposite = -1;
  for (int face = 1; face < scene.faceCount() && opposite < 0; ++face) {
    bool apart = true;
    for (const int a : scene.bodies[0].rest.faces[0])
      for (const int b : scene.bodies[0].rest.faces[face]) apart &= a != b;
    if (apart) opposite = face;
  }
  ASSERT_GE(opposite, 0);
  touch(0, 0, Vec3::UnitX(), 0.001);
  touch(1, opposite, -Vec3::UnitX(), 0.002);
  evaluate();
  double expected[2] = {0, 0};
  for (int face = 0; face < scene.faceCount(); ++face) {
    double weight[2] = {0, 0};
    for (const int vertex : scene.bodies[0].rest.faces[face]) {
      for (const int a : scene.bodies[0].rest.faces[0]) weight[0] += a == vertex ? 0.001 : 0;
      for (const int b : scene.bodies[0].rest.faces[opposite]) weight[1] += b == vertex ? 0.002 : 0;
    }
    if (face == 0) weight[1] = 0;  // its own contact alone counts
    if (face == opposite) weight[0] = 0;
    for (int tool = 0; tool < 2; ++tool) {
      if (weight[tool] > 0) expected[tool] += kStiffness * 0.005 * weight[tool] / (weight[0] + weight[1]);
    }
  }
  ASSERT_GT(expected[0], 0.5) << "more than the face itself";
  expectNear(force(0, 0), Vec3(-expected[0], 0, 0));
  expectNear(force(0, 1), Vec3(expected[1], 0, 0));
}

// Two jaws that pinch a triangle's two sides: the total cancels, what each jaw feels does not.
TEST_F(ToolShares, OpposingToolsFeelOppositeForces) {
  touch(0, 0, Vec3::UnitX(), 0.002);
  touch(1, 0, -Vec3::UnitX(), 0.002);
  evaluate();
  expectNear(state.forces[0].force_on_tool_N, Vec3::Zero());
  EXPECT_LT(force(0, 0).x(), -0.1);
  expectNear(force(0, 1), -force(0, 0));
}

TEST_F(ToolShares, ContactsThatOnlyHoldShareAlike) {
  touch(0, 0, -Vec3::UnitY(), 0);
  touch(1, 0, -Vec3::UnitY(), 0);
  evaluate();
  EXPECT_GT(force(0, 0).y(), 0.1);
  expectNear(force(0, 0), force(0, 1));
}

// Two blades on the top of a cube, their lower faces 2 and 5 mm below it and their nodes 0.5 mm short of
// that: nine nodes of each face displace by 2.5 and 5.5 mm.
TEST(ToolDisplacements, AreHowFarTheContactsWereShort) {
  Scene scene;
  scene.bodies.push_back({.name = "cube", .rest = makeBox({0.06, 0.06, 0.06})});
  const Vec3 size_m(0.02, 0.002, 0.01);
  for (const int first_node : {0, 18})
    scene.tools.push_back({.name = "blade",
                           .surface = {},
                           .box_size_m = size_m,
                           .nodes = makeGridNodes(size_m, {3, 3}),
                           .first_node = first_node});
  const auto blades = [](double left_m, double right_m) {
    return std::vector<ToolState>{{.pose = {.position_m = Vec3(-0.015, left_m + 0.001, 0)}},
                                  {.pose = {.position_m = Vec3(0.015, right_m + 0.001, 0)}}};
  };
  NodeContact contact(scene, {.margins_m = {0.0005}});
  std::vector<Vec3> positions_m = scene.bodies[0].rest.vertices_m;
  const std::vector<double> inverse_masses(positions_m.size(), 10.0);
  ContactOutcome outcome;
  ContactPatch patch;
  patch.resize(scene.vertexCount(), scene.faceCount(), 2);
  const std::vector<ToolState> above = blades(0.035, 0.035), pressed = blades(0.028, 0.025);
  contact.step({.positions_m = positions_m,
                .before_m = scene.bodies[0].rest.vertices_m,
                .tools_before = above,
                .tools_now = pressed,
                .dt_s = 0.001},
               inverse_masses, outcome, patch);
  ASSERT_EQ(outcome.contact_count, 18);
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  EXPECT_NEAR(sum(patch.tools[0].face_displacements_m), 9 * 0.0025, 1e-12);
  EXPECT_NEAR(sum(patch.tools[1].face_displacements_m), 9 * 0.0055, 1e-12);
  EXPECT_NEAR(sum(patch.tools[0].vertex_displacements_m), 9 * 0.0025, 1e-12) << "weights sum up to 1";
  EXPECT_NEAR(sum(patch.tools[1].vertex_displacements_m), 9 * 0.0055, 1e-12);
}

// Contacts of tissue vertices name their tool too: one blade over the left, one over the right edge of the
// top.
TEST(ToolDisplacements, VertexContactsBelongToTheToolThatHoldsThem) {
  Scene scene;
  scene.bodies.push_back({.name = "cube", .rest = makeBox({0.06, 0.06, 0.06})});
  for (int i = 0; i < 2; ++i) scene.tools.push_back({.name = "blade", .box_size_m = Vec3(0.02, 0.002, 0.08)});
  const auto blades = [](double y_m) {
    return std::vector<ToolState>{{.pose = {.position_m = Vec3(-0.03, y_m, 0)}},
                                  {.pose = {.position_m = Vec3(0.03, y_m, 0)}}};
  };
  NodeContact contact(scene, {.vertex_contacts = true, .margins_m = {0.0005}});
  std::vector<Vec3> positions_m = scene.bodies[0].rest.vertices_m;
  const std::vector<double> inverse_masses(positions_m.size(), 10.0);
  ContactOutcome outcome;
  ContactPatch patch;
  patch.resize(scene.vertexCount(), scene.faceCount(), 2);
  const std::vector<ToolState> above = blades(0.035), pressed = blades(0.029);
  contact.step({.positions_m = positions_m,
                .before_m = scene.bodies[0].rest.vertices_m,
                .tools_before = above,
                .tools_now = pressed,
                .dt_s = 0.001},
               inverse_masses, outcome, patch);
  // The four vertices, and the three edges across the top at the inner rim of each blade.
  ASSERT_EQ(outcome.contact_count, 4 + 6);
  for (int vertex = 0; vertex < scene.vertexCount(); ++vertex) {
    const Vec3& rest_m = scene.bodies[0].rest.vertices_m[vertex];
    for (const int tool : {0, 1}) {
      const double own_m = patch.tools[tool].vertex_displacements_m[vertex];
      const double other_m = patch.tools[1 - tool].vertex_displacements_m[vertex];
      if (rest_m.y() < 0) {
        EXPECT_EQ(own_m, 0);
      } else if ((rest_m.x() > 0) == (tool == 1)) {
        EXPECT_GE(own_m, 0.0025 - 1e-12) << "its own contact, and its shares of edges";
        EXPECT_LT(other_m, own_m) << "only edges that reach over to the other blade";
      }
    }
  }
}

TEST_F(ToolShares, ToolsSumUpToTheTotalOfEveryLaw) {
  touch(0, 0, Vec3(0.6, -0.8, 0), 0.0031);
  touch(1, 0, Vec3(0, -0.8, 0.6), 0.0007);
  touch(1, 4, Vec3(0, 0, -1), 0.0013);
  evaluate();
  for (std::size_t law = 0; law < 2; ++law) {
    EXPECT_GT(force(law, 0).norm(), 0.1);
    EXPECT_GT(force(law, 1).norm(), 0.1);
    expectNear(force(law, 0) + force(law, 1), state.forces[law].force_on_tool_N);
  }
}

}  // namespace
}  // namespace fissure::tool_shares_test
