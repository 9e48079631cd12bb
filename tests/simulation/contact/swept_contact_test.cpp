#include "contact/swept_contact.h"

#include <gtest/gtest.h>

#include <numeric>

#include "mesh/primitives.h"
#include "slow_distance.h"

namespace fissure::swept_contact_test {

namespace {

constexpr double kMargin_m = 0.0005;
constexpr double kMass_kg = 0.01;  ///< of each vertex
constexpr double kStep_s = 0.001;

/// A ball of 10 mm at the origin that stays where contact puts it, and box tools. Nothing but contact moves
/// it.
class Ball {
 public:
  Ball(const std::vector<Vec3>& sizes_m, const std::vector<Vec3>& at_m, SweptContactSettings settings = {},
       const std::vector<int>& fixed = {}) {
    scene.bodies.push_back({.name = "ball"});
    for (std::size_t t = 0; t < sizes_m.size(); ++t) {
      scene.tools.push_back({.name = "t", .surface = makeBox(sizes_m[t]), .box_size_m = sizes_m[t]});
      tools.push_back({.pose = {.position_m = at_m[t]}});
    }
    settings.margins_m = {kMargin_m};
    become(makeSphere(0.01, 2), std::move(settings));
    for (const int v : fixed) inverse_masses[v] = 0;
  }
  /// The body is of another shape from the beginning.
  void become(TriangleMesh rest, SweptContactSettings settings) {
    scene.bodies[0].rest = std::move(rest);
    inverse_masses.assign(scene.vertexCount(), 1 / kMass_kg);
    positions_m = scene.bodies[0].rest.vertices_m;
    contact.emplace(scene, std::move(settings));
    patch.resize(scene.vertexCount(), scene.faceCount(), scene.tools.size());
  }

  /// The tissue would go `drift_m`; each tool goes its way.
  void step(const std::vector<Vec3>& ways_m, const Vec3& drift_m = Vec3::Zero()) {
    before_m = positions_m;
    const std::vector<ToolState> were = tools;
    for (std::size_t t = 0; t < ways_m.size(); ++t) tools[t].pose.position_m += ways_m[t];
    for (std::size_t v = 0; v < positions_m.size(); ++v)
      if (inverse_masses[v] > 0) positions_m[v] += drift_m;
    contact->step({.positions_m = positions_m,
                   .before_m = before_m,
                   .tools_before = were,
                   .tools_now = tools,
                   .tool_bodies = bodies,
                   .dt_s = kStep_s},
                  inverse_masses, outcome, patch);
    for (std::size_t t = 0; t < bodies.size(); ++t) tools[t].pose.position_m += bodies[t].offset_m;
  }
  bool overlaps(std::size_t tool) const {
    SweptPairs pairs(scene.tools[tool], scene.bodies[0]);
    std::vector<Vec3> in_tool_m;
    for (const Vec3& p : positions_m) in_tool_m.push_back(tools[tool].pose.toBody(p));
    return pairs.overlap(in_tool_m);
  }
  /// Momentum of the last step's motion, over the time step.
  Vec3 force_N() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t v = 0; v < positions_m.size(); ++v)
      if (inverse_masses[v] > 0) sum += contact->motion_m()[v] / inverse_masses[v];
    return sum / (kStep_s * kStep_s);
  }

  Scene scene;
  std::vector<ToolState> tools;
  std::vector<ToolBody> bodies;  ///< none: the tools are led
  std::vector<double> inverse_masses;
  std::vector<Vec3> before_m, positions_m;
  std::optional<SweptContact> contact;
  ContactOutcome outcome;
  ContactPatch patch;
};

const Vec3 kBlade_m(0.04, 0.002, 0.015);

class Rounds : public testing::TestWithParam<int> {};

// However fast, and by truncation alone: the blade takes the tissue along.
TEST_P(Rounds, ABladeNeverEntersTissue) {
  for (const double way_m : {0.0003, 0.003, 0.03}) {
    Ball ball({kBlade_m}, {Vec3(0.001, 0.0125, 0.0005)}, {.rounds = GetParam()});
    for (int i = 0; i < 20; ++i) {
      ball.step({Vec3(0, -way_m, 0)});
      ASSERT_FALSE(ball.overlaps(0)) << way_m << ", step " << i;
      ASSERT_NEAR((ball.force_N() + ball.outcome.reaction_on_tool_N).norm(), 0,
                  1e-12 * (1 + ball.force_N().norm()));
    }
    EXPECT_LT(ball.positions_m[0].y(), 0.012) << "pushed ahead";
    EXPECT_EQ(ball.contact->truncationCounts().no_room_steps, 0);
    EXPECT_TRUE(GetParam() == 1 || (ball.contact->truncationCounts().steps > 0) == (GetParam() == 0))
        << way_m;
  }
}

/// A plate of a tenth of a gram that contacts push, 2 mm thick, between two balls of 10 mm.
class PlateBetweenBalls : public Ball {
 public:
  PlateBetweenBalls(double below_m, double above_m, int rounds)
      : Ball({Vec3(0.04, 0.002, 0.04)}, {Vec3::Zero()}) {
    TriangleMesh both = makeSphere(0.01, 2);
    const TriangleMesh other = both;
    count_ = static_cast<int>(both.vertices_m.size());
    for (Vec3& vertex : both.vertices_m) vertex.y() -= 0.011 + below_m;
    for (const Vec3& vertex : other.vertices_m)
      both.vertices_m.push_back(vertex + Vec3(0, 0.011 + above_m, 0));
    for (const Face& f : other.faces) both.faces.push_back({f[0] + count_, f[1] + count_, f[2] + count_});
    become(both, {.rounds = rounds, .margins_m = {kMargin_m}});
    bodies = {{.inverse_mass_1_kg = 1e4}};
  }
  void fixLower() { std::fill_n(inverse_masses.begin(), count_, 0); }
  void fixUpper() { std::fill_n(inverse_masses.begin() + count_, count_, 0); }
  double height_m() const { return tools[0].pose.position_m.y(); }
  /// Of tool and contacts, times the time step.
  double imbalance_kg_m() const {
    return (bodies[0].motion_m / bodies[0].inverse_mass_1_kg - kStep_s * kStep_s * outcome.reaction_on_tool_N)
        .norm();
  }

 private:
  int count_ = 0;
};

// A fixed ball stands above, far when the step begins.
TEST_P(Rounds, AToolThrownByTissueDoesNotEnterTissueBeyond) {
  PlateBetweenBalls balls(0.0002, 0.003, GetParam());
  balls.fixUpper();
  for (int i = 0; i < 5; ++i) {
    balls.step({Vec3::Zero()}, Vec3(0, i == 0 ? 0.008 : 0, 0));
    ASSERT_FALSE(balls.overlaps(0)) << i;
    ASSERT_NEAR(balls.imbalance_kg_m(), 0, 1e-15) << i;
  }
  EXPECT_EQ(balls.contact->truncationCounts().no_room_steps, 0);
  EXPECT_TRUE(GetParam() == 0 || balls.height_m() > 0.0001) << "pushed";
}

// Pushed up by what is left of the lower ball's margin, it meets tissue that would not have come down to it.
TEST_P(Rounds, WhatAPushedToolMeetsIsFound) {
  PlateBetweenBalls balls(0.0001, 0.0016, GetParam());
  balls.fixLower();
  balls.step({Vec3::Zero()}, Vec3(0, -0.00155, 0));
  EXPECT_FALSE(balls.overlaps(0));
  EXPECT_NEAR(balls.imbalance_kg_m(), 0, 1e-15);
  EXPECT_TRUE(GetParam() < 4 || balls.height_m() > 0.0001) << "pushed";
}
INSTANTIATE_TEST_SUITE_P(Rounds, Rounds, testing::Values(0, 1, 4));

// What is stopped has the velocity of the tool that stopped it.
TEST(Truncation, AStoppedVertexTakesTheToolsVelocity) {
  Ball ball({kBlade_m}, {Vec3(0.001, 0.0125, 0.0005)}, {.rounds = 0});
  const Vec3 way_m(0, -0.003, 0), drift_m(0, 0.001, 0);
  ball.step({way_m}, drift_m);
  int stopped = 0;
  for (std::size_t v = 0; v < ball.positions_m.size(); ++v) {
    const Vec3 motion_m = ball.contact->motion_m()[v];
    if (motion_m.isZero(0)) continue;
    ++stopped;
    EXPECT_NEAR((drift_m + motion_m - way_m).norm(), 0, 1e-15);
  }
  EXPECT_EQ(stopped, ball.contact->truncationCounts().vertices);
  EXPECT_GT(stopped, 0);
  EXPECT_NEAR(
      (ball.outcome.reaction_on_tool_N + stopped * kMass_kg * (way_m - drift_m) / (kStep_s * kStep_s)).norm(),
      0, 1e-6);
}

// Nothing moves a fixed vertex: such a step is counted, and what is not fixed stays out.
TEST(Truncation, AFixedVertexLeavesNoRoom) {
  std::vector<int> all(66);
  std::iota(all.begin(), all.end(), 0);
  Ball ball({kBlade_m}, {Vec3(0.001, 0.0125, 0.0005)}, {}, all);
  const std::vector<Vec3> rest_m = ball.positions_m;
  ball.step({Vec3(0, -0.006, 0)});
  EXPECT_EQ(ball.positions_m, rest_m);
  EXPECT_EQ(ball.contact->truncationCounts().no_room_steps, 1);
}

// Two plates that close altogether: the first of the scenario stays free of tissue, and it ends.
TEST(Truncation, BetweenToolsThatCloseTheFirstStaysFree) {
  const Vec3 plate_m(0.05, 0.002, 0.05);
  Ball ball({plate_m, plate_m}, {Vec3(0, 0.0125, 0), Vec3(0, -0.0125, 0)});
  int without_room = 0;
  for (int i = 0; i < 14; ++i) {
    ball.step({Vec3(0, -0.001, 0), Vec3(0, 0.001, 0)});
    const bool counted = ball.contact->truncationCounts().no_room_steps > without_room;
    without_room += counted ? 1 : 0;
    for (const Vec3& p : ball.positions_m) ASSERT_LT(p.norm(), 1) << "step " << i;
    EXPECT_TRUE(counted || !(ball.overlaps(0) || ball.overlaps(1))) << "step " << i;
  }
  EXPECT_GT(without_room, 0);
  EXPECT_LT(without_room, 10) << "as long as there is room it is kept";
}

// A tool that starts inside is freed on its shortest way, at most so far in a step, without throwing tissue.
TEST(StartsInside, AToolIsFreedStepByStepAndThrowsNothing) {
  Ball ball({kBlade_m}, {Vec3(0.0005, 0.006, 0.0005)}, {.max_displacement_m = 0.002});
  ASSERT_TRUE(ball.overlaps(0));
  int steps = 0;
  while (ball.overlaps(0) && steps < 20) {
    ball.step({Vec3::Zero()});
    EXPECT_LT(ball.outcome.reaction_on_tool_N.norm(), 1e-6) << "displacement without motion";
    ++steps;
  }
  EXPECT_GE(steps, 3) << "6 mm at 2 mm a step";
  EXPECT_LE(steps, 4);
  ball.step({Vec3(0, -0.001, 0)});
  EXPECT_FALSE(ball.overlaps(0));
}

double sumOf(const std::vector<double>& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

// The weight of a triangle's force: all of it at a margin, none at three, nothing in between jumps.
TEST(FaceWeights, FadeOutBetweenOneMarginAndThree) {
  double last = 1e9;
  for (const double margins : {1.0, 1.2, 1.6, 2.0, 2.5, 2.9, 3.1}) {
    Ball ball({Vec3(0.05, 0.002, 0.05)}, {Vec3(0.0003, 0.011 + margins * kMargin_m, 0.0002)});
    ball.step({Vec3::Zero()});
    const double most = *std::max_element(ball.patch.face_weights.begin(), ball.patch.face_weights.end());
    EXPECT_EQ(most == 0, margins > 3) << margins;
    EXPECT_TRUE(margins > 1 || most > 1 - 1e-6) << margins;
    const double sum = sumOf(ball.patch.face_weights);
    EXPECT_LT(sum, last) << margins;
    last = sum;
  }
}

// A blade that slides over tissue: triangles come and go as its rim passes vertices and crosses edges, and
// in each step of 0.01 mm the sum of all weights changes by no more than it could without jumps.
TEST(FaceWeights, ChangeWithoutJumpsAsARimSlidesOverEdges) {
  Ball ball({kBlade_m}, {Vec3(-0.003, 0.0106, 0.0004)});
  for (int i = 0; i < 60; ++i) ball.step({Vec3(0, -0.00003, 0)});
  double last = sumOf(ball.patch.face_weights), least = last, most = last, jump = 0;
  for (int i = 0; i < 800; ++i) {
    ball.step({Vec3(0, 0, 0.00001)});
    const double sum = sumOf(ball.patch.face_weights);
    if (i > 0) jump = std::max(jump, std::abs(sum - last));
    least = std::min(least, sum);
    most = std::max(most, sum);
    last = sum;
  }
  EXPECT_GT(most - least, 3) << "triangles came or went";
  EXPECT_LT(jump, 0.1);
}

// The tissue's own stiffness would take it right through the rim of a tool that holds it. It is held by what
// is near, whatever would have crossed there.
TEST(Response, LooksForCrossingsOnlyWhereWhatIsNearDoesNotHold) {
  std::vector<int> contacts;
  for (const double drift_m : {0.0, 0.0005, 0.002}) {
    Ball ball({kBlade_m}, {Vec3(0.001, 0.0111, 0.0005)});
    for (int i = 0; i < 10; ++i) ball.step({Vec3(0, -0.0001, 0)});
    ball.step({Vec3::Zero()}, Vec3(0, drift_m, 0));
    contacts.push_back(ball.outcome.candidate_count);
    EXPECT_EQ(ball.contact->rounds(), 11) << drift_m;
    EXPECT_FALSE(ball.overlaps(0)) << drift_m;
  }
  EXPECT_GT(contacts[0], 0);
  EXPECT_EQ(contacts, std::vector<int>(3, contacts[0]));
}

// Two blades come together from 1.6 mm to 0.6 mm, less than both margins, with the edge of a wedge between
// them.
TEST(OpposingContacts, OfAnEdgeShareTheRoomThatIsLeft) {
  const Vec3 blade_m(0.05, 0.001, 0.001);
  Ball ball({blade_m, blade_m}, {Vec3(0.0258, 0, 0), Vec3(-0.0258, 0, 0)});
  const TriangleMesh wedge{{{0, 0, -0.03}, {0, 0, 0.03}, {0.002, -0.02, 0}, {-0.002, -0.02, 0}},
                           {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}}};
  ball.become(wedge, {.margins_m = {kMargin_m}});
  for (int i = 0; i < 5; ++i) ball.step({Vec3(-0.0001, 0, 0), Vec3(0.0001, 0, 0)});
  for (const int end : {0, 1}) EXPECT_NEAR(ball.positions_m[end].x(), 0, 0.1 * kMargin_m) << "in the middle";
  EXPECT_GT(ball.outcome.contact_count, 2) << "of both blades";
  EXPECT_EQ(ball.contact->truncationCounts().steps, 0);
  EXPECT_FALSE(ball.overlaps(0) || ball.overlaps(1));
}

// Two tools that move as one are one obstacle: what is jammed between them rides with both.
TEST(Truncation, ToolsThatMoveAsOneLeaveTheRoomTheyHave) {
  const Vec3 plate_m(0.05, 0.002, 0.05);
  Ball ball({plate_m, plate_m}, {Vec3(0, 0.0112, 0), Vec3(0, -0.0112, 0)}, {.rounds = 0});
  const Vec3 way_m(0.001, 0.004, -0.002);
  for (int i = 0; i < 10; ++i) {
    ball.step({way_m, way_m});
    ASSERT_FALSE(ball.overlaps(0) || ball.overlaps(1)) << "step " << i;
  }
  EXPECT_GT(ball.contact->truncationCounts().steps, 0);
  EXPECT_EQ(ball.contact->truncationCounts().no_room_steps, 0);
}

}  // namespace
}  // namespace fissure::swept_contact_test
