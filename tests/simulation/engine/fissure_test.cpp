// A blade in the slit between two lobes of one body: tissue on both sides of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/grid_nodes.h"
#include "engine/simulation.h"
#include "mesh/primitives.h"
#include "scene/fixed_vertices.h"
#include "scene/place.h"

namespace fissure::fissure_test {

namespace {

constexpr double kStep_s = 0.001;
constexpr int kNodesPerFace = 12 * 8;

/// Lobes 40 mm high in the air, free or held at their flat side, and a blade 3 mm thick with its edge at
/// `edge_at_m`.
class Fissure {
 public:
  Fissure(double slit_width_m, double edge_at_m, bool held)
      : pose_{.position_m = Vec3(0, edge_at_m + 0.02, 0)} {
    scenario_.time.step_s = kStep_s;
    scenario_.world.gravity_m_s2 = Vec3::Zero();
    BodySettings body;
    body.name = "lobes";
    body.shape = LobesShape{
        .size_m = {0.08, 0.04, 0.08}, .slit_depth_m = 0.028, .slit_width_m = slit_width_m, .edge_m = 0.01};
    body.material.linear_stiffness = 0.5;
    body.solver.pose_matching = 0.02;
    body.solver.position_iterations = 10;
    if (held) body.fixed = {{.below_m = 0.001}};
    scenario_.bodies = {body};
    const Vec3 size_m(0.003, 0.04, 0.02);
    scenario_.tools.resize(1);
    scenario_.tools[0].shape = BoxShape{size_m};
    scene_.bodies.push_back({.name = body.name, .rest = placeBody(body)});
    scene_.bodies[0].fixed_vertices = fixedVertices(body, scene_.bodies[0].rest.vertices_m);
    scene_.tools.push_back({.name = "blade", .surface = makeBox(size_m), .box_size_m = size_m});
    scene_.tools[0].nodes = makeGridNodes(size_m, {12, 8});
    simulation_ = makeSimulation(
        scenario_, {.name = "p", .pipeline = PipelineKind::fukuhara, .response = ContactResponse::momentum},
        scene_, {pose_});
  }

  void step(const Vec3& way_m, double turn_rad = 0) {
    pose_.position_m += way_m;
    pose_.orientation = Quat(Eigen::AngleAxisd(turn_rad, Vec3::UnitY())) * pose_.orientation;
    simulation_->step({pose_});
  }
  const State& state() const { return simulation_->state(); }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state().masses_kg.size(); ++i)
      sum += state().masses_kg[i] * state().velocities_m_s[i];
    return sum;
  }
  /// Mean x of the rim's vertices on one side (sign -1 or 1), in metres.
  double rim_m(double sign) const {
    double sum_m = 0;
    int count = 0;
    const std::vector<Vec3>& rest = scene_.bodies[0].rest.vertices_m;
    for (std::size_t v = 0; v < rest.size(); ++v) {
      if (rest[v].y() < 0.035 || sign * rest[v].x() <= 0 || sign * rest[v].x() > 0.002) continue;
      sum_m += state().positions_m[v].x();
      ++count;
    }
    EXPECT_GT(count, 2);
    return sum_m / count;
  }
  /// Nodes of the face towards `sign` x whose contact acts.
  long acting(double sign) const {
    const auto first = state().contact.node_states.begin() + (sign > 0 ? 0 : kNodesPerFace);
    return std::count(first, first + kNodesPerFace, NodeState::feasible);
  }

 private:
  Scenario scenario_;
  Scene scene_;
  Pose pose_;
  std::unique_ptr<Simulation> simulation_;
};

TEST(FissureInOneBody, ACentredBladePartsBothLobesAlikeAndHoldsBothAtOnce) {
  Fissure world(0.001, 0.044, true);
  const double left_m = world.rim_m(-1), right_m = world.rim_m(1);
  for (int i = 0; i < 240; ++i) world.step(Vec3(0, -0.0001, 0));
  EXPECT_GT(world.acting(-1), 20);
  EXPECT_GT(world.acting(1), 20);
  EXPECT_EQ(world.state().contact.infeasible_count, 0) << "depths together below the blade's thickness";
  const double left_opened_m = left_m - world.rim_m(-1), right_opened_m = world.rim_m(1) - right_m;
  EXPECT_GT(left_opened_m, 0.0005);
  EXPECT_NEAR(left_opened_m / right_opened_m, 1, 0.05);
}

// What the lobes gain of momentum in each step is what the contacts of both faces took, together, while the
// blade turns by 20 degrees and then takes them aside.
TEST(FissureInOneBody, MomentumBalancesInEachStep) {
  Fissure world(0.006, 0.03, false);
  double pressed_N = 0, turned_kg_m_s = 0;
  long both = 0;
  for (int i = 0; i < 400; ++i) {
    const bool turning = i < 200;
    const Vec3 before = world.momentum();
    world.step(Vec3(turning ? 0 : 0.0001, 0, 0), turning ? 0.00175 : 0);
    const Vec3 expected = before - kStep_s * world.state().contact.reaction_on_tool_N;
    ASSERT_NEAR((world.momentum() - expected).norm(), 0, 1e-12) << "step " << i;
    if (world.acting(-1) > 0 && world.acting(1) > 0) ++both;
    if (turning) turned_kg_m_s = std::max(turned_kg_m_s, std::abs(world.momentum().x()));
    pressed_N = std::max(pressed_N, world.state().contact.reaction_on_tool_N.norm());
  }
  EXPECT_GT(both, 100);
  EXPECT_GT(pressed_N, 0.5) << "no contact, no test";
  EXPECT_NEAR(world.momentum().x() / (0.1 * 0.1), 1, 0.2) << "taken along at the blade's speed";
  EXPECT_LT(turned_kg_m_s, 0.1 * world.momentum().x()) << "parted alike: no push to one side";
}

}  // namespace
}  // namespace fissure::fissure_test
