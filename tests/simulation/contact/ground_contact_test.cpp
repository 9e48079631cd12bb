#include "contact/ground_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/swept_contact.h"
#include "mesh/primitives.h"

namespace fissure::ground_contact_test {

namespace {

constexpr double kMargin_m = 0.0005;
constexpr double kMass_kg = 0.01;  ///< of each vertex
constexpr double kStep_s = 0.001;
constexpr double kExact = 1e-15;

/// A ball of 10 mm at the origin whose vertices nothing but contact holds together, the ground, and at most
/// one box tool.
class Ball {
 public:
  explicit Ball(const HalfSpace& ground, double friction = 0, int rounds = 4) {
    scene.bodies.push_back({.name = "ball", .rest = makeSphere(0.01, 2)});
    settings.rounds = rounds;
    settings.margins_m = {kMargin_m};
    settings.body_frictions = {friction};
    settings.ground = ground;
    positions_m = scene.bodies[0].rest.vertices_m;
    inverse_masses.assign(positions_m.size(), 1 / kMass_kg);
  }
  void addTool(const Vec3& size_m, const Vec3& at_m) {
    scene.tools.push_back({.name = "t", .surface = makeBox(size_m), .box_size_m = size_m});
    tools.push_back({.pose = {.position_m = at_m}});
  }

  /// Each vertex would go its own way.
  void step(const std::vector<Vec3>& ways_m, const Vec3& tools_way_m = Vec3::Zero()) {
    if (!contact) {
      contact.emplace(scene, settings);
      patch.resize(scene.vertexCount(), scene.faceCount(), scene.tools.size());
    }
    before_m = positions_m;
    const std::vector<ToolState> were = tools;
    for (ToolState& tool : tools) tool.pose.position_m += tools_way_m;
    for (std::size_t v = 0; v < positions_m.size(); ++v)
      if (inverse_masses[v] > 0) positions_m[v] += ways_m[v];
    solved_m = positions_m;
    contact->step({.positions_m = positions_m,
                   .before_m = before_m,
                   .tools_before = were,
                   .tools_now = tools,
                   .dt_s = kStep_s},
                  inverse_masses, outcome, patch);
  }
  void step(const Vec3& way_m, const Vec3& tools_way_m = Vec3::Zero()) {
    step(std::vector<Vec3>(positions_m.size(), way_m), tools_way_m);
  }
  double lowest_m() const {
    double lowest_m = 1;
    for (std::size_t v = 0; v < positions_m.size(); ++v)
      if (inverse_masses[v] > 0) lowest_m = std::min(lowest_m, settings.ground->height_m(positions_m[v]));
    return lowest_m;
  }
  bool overlapsTool() const {
    SweptPairs pairs(scene.tools[0], scene.bodies[0]);
    std::vector<Vec3> in_tool_m;
    for (const Vec3& p : positions_m) in_tool_m.push_back(tools[0].pose.toBody(p));
    return pairs.overlap(in_tool_m);
  }
  /// Of all contacts on the tissue in the last step.
  Vec3 force_N() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t v = 0; v < positions_m.size(); ++v)
      if (inverse_masses[v] > 0) sum += contact->motion_m()[v] / inverse_masses[v];
    return sum / (kStep_s * kStep_s);
  }

  Scene scene;
  SweptContactSettings settings;
  std::vector<ToolState> tools;
  std::vector<double> inverse_masses;
  std::vector<Vec3> before_m, solved_m, positions_m;
  std::optional<SweptContact> contact;
  ContactOutcome outcome;
  ContactPatch patch;
};

const HalfSpace kFloor{.point_m = Vec3(0.3, -0.01, 0.2)};  // right under the ball

class GroundByRounds : public testing::TestWithParam<int> {};

// A slope through (0, -0.012, 0): what would end below stays on it, at the place that it would have reached.
TEST_P(GroundByRounds, WhatWouldEndBelowEndsOnTheGround) {
  const HalfSpace slope{.point_m = Vec3(0, -0.012, 0), .normal = Vec3(0.6, 0.8, 0)};
  Ball ball(slope, 0, GetParam());
  ball.step(Vec3(-0.001, -0.02, 0.0005));
  int held = 0;
  for (std::size_t v = 0; v < ball.positions_m.size(); ++v) {
    const double depth_m = std::max(-slope.height_m(ball.solved_m[v]), 0.0);
    EXPECT_NEAR((ball.positions_m[v] - ball.solved_m[v] - depth_m * slope.normal).norm(), 0, kExact);
    held += depth_m > 0 ? 1 : 0;
  }
  EXPECT_GT(held, 20);
  EXPECT_LT(held, 66);
  EXPECT_NEAR((ball.force_N() + *ball.outcome.ground_reaction_N).norm(), 0, 1e-9 * ball.force_N().norm());
  EXPECT_NEAR(ball.outcome.ground_reaction_N->cross(slope.normal).norm(), 0, 1e-9 * ball.force_N().norm());
  EXPECT_EQ(ball.contact->truncationCounts().vertices, GetParam() == 0 ? held : 0);
}
INSTANTIATE_TEST_SUITE_P(Rounds, GroundByRounds, testing::Values(0, 4));

// No tool has to do with it: not in a colliding state, in no count, no force of a law, no reaction of a tool.
TEST(Ground, ItsContactsAreNoColliding) {
  Ball ball(kFloor);
  ball.addTool(Vec3(0.01, 0.01, 0.01), Vec3(0, 0.1, 0));
  ball.step(Vec3(0, -0.003, 0));
  EXPECT_GT(ball.force_N().y(), 100);
  EXPECT_EQ(ball.outcome.reaction_on_tool_N, Vec3::Zero());
  EXPECT_EQ(ball.outcome.contact_count, 0);
  EXPECT_EQ(ball.outcome.candidate_count, 0);
  EXPECT_EQ(std::accumulate(ball.patch.vertex_contact.begin(), ball.patch.vertex_contact.end(), 0), 0);
  for (const double weight : ball.patch.face_weights) EXPECT_EQ(weight, 0);
}

// Each vertex rubs by at most mu times its push, against its way, and where it could by less it stays.
TEST(Ground, FrictionIsCoulombsConeAtEachVertex) {
  const double mu = 0.4;  // 0.8 of the ground by 0.5 of the body
  HalfSpace ground = kFloor;
  ground.friction = 0.8;
  ground.point_m.y() = 0.011;  // all below
  Ball ball(ground, 0.5);
  for (Vec3& p : ball.positions_m) p.y() = 0.011;  // flat on it
  std::vector<Vec3> ways_m(ball.positions_m.size());
  for (std::size_t v = 0; v < ways_m.size(); ++v)
    ways_m[v] = Vec3(2e-5 * std::cos(0.7 * v) * v, -0.001, 2e-5 * std::sin(0.7 * v) * v);
  ball.step(ways_m);
  int sticking = 0, slipping = 0;
  for (std::size_t v = 0; v < ways_m.size(); ++v) {
    const Vec3 motion_m = ball.contact->motion_m()[v];
    const Vec3 along_m(motion_m.x(), 0, motion_m.z()), way_m(ways_m[v].x(), 0, ways_m[v].z());
    EXPECT_NEAR(motion_m.y(), 0.001, kExact);
    EXPECT_LE(along_m.norm(), mu * motion_m.y() + kExact);
    if (way_m.norm() < mu * 0.001) {
      ++sticking;
      EXPECT_NEAR((along_m + way_m).norm(), 0, kExact);
    } else {
      ++slipping;
      EXPECT_NEAR((along_m + mu * 0.001 * way_m.normalized()).norm(), 0, kExact);
    }
  }
  EXPECT_GT(std::min(sticking, slipping), 10);
}

// A plate squeezes the ball flat: down to a hundredth of its margin above the ground there is room.
TEST(Ground, TissueBetweenAToolAndTheGroundIsSqueezed) {
  Ball ball(kFloor);
  ball.addTool(Vec3(0.06, 0.002, 0.06), Vec3(0, 0.0115, 0));
  for (int i = 0; i < 2048; ++i) {
    ball.step(Vec3::Zero(), Vec3(0, -1e-5, 0));  // at last 20 um above the ground
    ASSERT_GE(ball.lowest_m(), 0) << "step " << i;
    ASSERT_FALSE(ball.overlapsTool()) << "step " << i;
    ASSERT_NEAR((ball.force_N() + ball.outcome.reaction_on_tool_N + *ball.outcome.ground_reaction_N).norm(),
                0, 1e-9 * (1 + ball.force_N().norm()));
  }
  EXPECT_NEAR(ball.tools[0].pose.position_m.y(), -0.00898, 1e-9);
  EXPECT_EQ(ball.contact->truncationCounts().steps, 0);
  ball.step(Vec3::Zero());  // at rest in less than a margin tool and ground do not press against each other
  EXPECT_NEAR(ball.outcome.reaction_on_tool_N.norm(), 0, 1e-6);
  EXPECT_NEAR(ball.outcome.ground_reaction_N->norm(), 0, 1e-6);
}

// A tool that goes through the ground leaves no room: then tissue stays above the ground.
TEST(Ground, ComesBeforeTools) {
  Ball ball(kFloor);
  ball.addTool(Vec3(0.06, 0.002, 0.06), Vec3(0, 0.0115, 0));
  for (int i = 0; i < 24; ++i) {
    ball.step(Vec3::Zero(), Vec3(0, -0.001, 0));
    ASSERT_GE(ball.lowest_m(), -1e-9) << "step " << i;
    if (ball.contact->truncationCounts().no_room_steps == 0) {
      ASSERT_FALSE(ball.overlapsTool()) << "step " << i;
    }
    for (const Vec3& p : ball.positions_m) ASSERT_LT(p.norm(), 0.1) << "step " << i;
  }
  EXPECT_LT(ball.tools[0].pose.position_m.y(), -0.01);
  EXPECT_GT(ball.contact->truncationCounts().no_room_steps, 0);
  EXPECT_LT(ball.contact->truncationCounts().no_room_steps, 8) << "as long as there is room it is kept";
}

TEST(Ground, FixedVerticesMayBeBelow) {
  HalfSpace ground = kFloor;
  ground.point_m.y() = -0.005;
  Ball ball(ground);
  int fixed = 0;
  for (std::size_t v = 0; v < ball.positions_m.size(); ++v)
    if (ball.positions_m[v].y() < -0.006) ball.inverse_masses[v] = (++fixed, 0);
  const std::vector<Vec3> rest_m = ball.positions_m;
  ball.step(Vec3(0, -0.002, 0));
  ASSERT_GT(fixed, 5);
  for (std::size_t v = 0; v < ball.positions_m.size(); ++v)
    if (ball.inverse_masses[v] == 0) {
      EXPECT_EQ(ball.positions_m[v], rest_m[v]);
    }
  EXPECT_GE(ball.lowest_m(), 0);
  EXPECT_EQ(ball.contact->truncationCounts().steps, 0);
  EXPECT_EQ(ball.contact->truncationCounts().no_room_steps, 0);
}

// What starts below is lifted, and thrown nowhere.
TEST(Ground, WhatStartsBelowIsLiftedWithoutMotion) {
  HalfSpace ground = kFloor;
  ground.point_m.y() = -0.008;
  Ball ball(ground);
  ball.step(Vec3::Zero());
  EXPECT_EQ(ball.lowest_m(), 0);
  for (const Vec3& motion_m : ball.contact->motion_m()) EXPECT_NEAR(motion_m.norm(), 0, kExact);
}

// From far above to the ground itself a tool's target changes by no more than half of what its height does.
TEST(GroundContact, ATargetGivesWayWithoutAJump) {
  const GroundContact ground(HalfSpace{}, 0.001, {0});
  double last_m = 0;
  for (double height_m = 0; height_m < 0.003; height_m += 1e-5) {
    ContactConstraint contact{
        .position_m = Vec3(0, height_m, 0), .normal = Vec3(0, -1, 0), .target_m = 0.0005};
    ground.makeRoomUnder(contact);
    EXPECT_LE(std::abs(contact.target_m - last_m), 0.51e-5) << height_m;
    last_m = contact.target_m;
  }
  EXPECT_EQ(last_m, 0.0005);
}

}  // namespace
}  // namespace fissure::ground_contact_test
