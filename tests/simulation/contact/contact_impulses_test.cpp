#include "contact/contact_impulses.h"

#include <gtest/gtest.h>

#include <random>

namespace fissure::contact_impulses_test {

namespace {

constexpr double kExact = 1e-15;

/// Vertices of 0.1 kg and 0.05 kg (the third is fixed) over a tool whose upper face is at y = 0 at the end of
/// the step. Heights in metres, before the step and as predicted.
class ContactImpulsesTest : public testing::Test {
 protected:
  ContactImpulsesTest() {
    for (double x : {0.0, 0.01, 0.02}) positions.emplace_back(x, 0, 0);
    before = positions;
  }
  void heights(int vertex, double before_m, double now_m) {
    before[vertex].y() = before_m;
    positions[vertex].y() = now_m;
  }
  void hold(std::array<double, 3> weights) {
    constraints.push_back(
        {.vertices = {0, 1, 2}, .weights = weights, .position_m = Vec3::Zero(), .normal = Vec3(0, 1, 0)});
  }
  /// The tool rose by `tool_way_m` in the step.
  void apply(double tool_way_m = 0, int sweeps = 1, double least_mobility = 0) {
    impulses.emplace(3, sweeps, least_mobility);
    const std::vector<ToolState> was = {{.pose = {.position_m = Vec3(0, -tool_way_m, 0)}}};
    const std::vector<ToolState> is(1);
    impulses->apply(constraints, inverse_masses,
                    {.positions_m = positions,
                     .before_m = before,
                     .tools_before = was,
                     .tools_now = is,
                     .tool_bodies = bodies});
  }
  Vec3 total() const { return impulses->total(std::vector<double>(3, 1.0)); }
  double motion(int vertex) const { return impulses->motion_m()[vertex].y(); }

  std::vector<Vec3> before, positions;
  std::vector<double> inverse_masses = {10, 20, 0};
  std::vector<ContactConstraint> constraints;
  std::vector<ToolBody> bodies;  ///< none: the tool is led
  std::optional<ContactImpulses> impulses;
};

TEST_F(ContactImpulsesTest, AMassThatArrivesIsStoppedAndItsMomentumTaken) {
  heights(0, 0.0005, -0.001);
  hold({1, 0, 0});
  apply();
  EXPECT_NEAR(positions[0].y(), 0, kExact);
  EXPECT_NEAR(motion(0), 0.001, kExact);
  EXPECT_NEAR(total().y(), 0.1 * 0.001, kExact);
}

// A point that hangs on a fixed vertex and is to be held throws the other one far: not where that is ruled
// out.
TEST_F(ContactImpulsesTest, AContactThatCouldOnlyThrowAVertexIsNone) {
  hold({0.001, 0, 0.999});
  heights(2, 0.001, -0.001);
  apply();
  EXPECT_GT(positions[0].y(), 0.9) << "metres";
  positions[0] = before[0];
  apply(0, 1, 0.01);
  EXPECT_EQ(positions[0], before[0]);
  EXPECT_EQ(impulses->pushing(), 0);
  EXPECT_EQ(total(), Vec3::Zero());
  hold({0.2, 0, 0.8});
  apply(0, 1, 0.01);
  EXPECT_GT(total().y(), 0) << "a share of 0.04 of the vertex's mobility";
}

// Powers of two: the first push is exact, and no later sweep finds anything left.
TEST_F(ContactImpulsesTest, SweepsAreCountedAndPushesThatMoveTissue) {
  inverse_masses[0] = 8;
  heights(0, 0.0005, -0x1p-10);
  apply(0, 3);
  EXPECT_EQ(impulses->counts().sweeps, 0) << "no contact";
  hold({1, 0, 0});
  apply(0, 3);
  EXPECT_EQ(impulses->counts().sweeps, 2 + 1) << "to push out, and to find nothing left; none to forget";
  EXPECT_EQ(impulses->counts().pushes, 1);
}

TEST_F(ContactImpulsesTest, ForgettingOldOverlapIsAPushToo) {
  inverse_masses[0] = 8;
  heights(0, -0x1p-11, -0x1p-11);
  hold({1, 0, 0});
  apply(0, 3);
  EXPECT_EQ(impulses->counts().pushes, 2);
}

TEST_F(ContactImpulsesTest, AToolThatIsABodyGivesWayByItsShare) {
  bodies = {{.inverse_mass_1_kg = 30}};
  heights(0, 0.0005, -0.001);
  hold({1, 0, 0});
  apply();
  EXPECT_NEAR(positions[0].y(), -0.00075, kExact);
  EXPECT_NEAR(bodies[0].offset_m.y(), -0.00075, kExact) << "where the mass is";
  EXPECT_NEAR(bodies[0].motion_m.y(), -0.00075, kExact);
  EXPECT_NEAR(total().y(), 0.1 * 0.00025, kExact);
}

TEST_F(ContactImpulsesTest, AToolThatIsABodyIsMovedOutOfOldOverlapWithoutMotion) {
  bodies = {{.inverse_mass_1_kg = 30}};
  heights(0, -0.0005, -0.0005);
  hold({1, 0, 0});
  apply();
  EXPECT_NEAR(positions[0].y(), -0.000375, kExact);
  EXPECT_NEAR(bodies[0].offset_m.y(), -0.000375, kExact);
  EXPECT_NEAR(motion(0), 0, kExact);
  EXPECT_NEAR(bodies[0].motion_m.y(), 0, kExact);
}

TEST_F(ContactImpulsesTest, AFixedVertexPushesAToolThatIsABody) {
  bodies = {{.inverse_mass_1_kg = 30}};
  heights(2, 0.0005, -0.001);
  hold({0, 0, 1});
  apply(0, 1, 0.01);
  EXPECT_NEAR(bodies[0].motion_m.y(), -0.001, kExact);
  EXPECT_NEAR(total().y(), 0.001 / 30, kExact);
}

TEST_F(ContactImpulsesTest, AMassBeforeAToolTakesTheToolsWay) {
  heights(0, -0.002, -0.002);  // it touched the tool, which rose by 2 mm
  hold({1, 0, 0});
  apply(0.002);
  EXPECT_NEAR(positions[0].y(), 0, kExact);
  EXPECT_NEAR(motion(0), 0.002, kExact);
}

TEST_F(ContactImpulsesTest, OldOverlapIsUndoneWithoutMotion) {
  heights(0, -0.0005, -0.0005);
  hold({1, 0, 0});
  apply();
  EXPECT_NEAR(positions[0].y(), 0, kExact);
  EXPECT_NEAR(motion(0), 0, kExact);
  EXPECT_NEAR(total().y(), 0, kExact);
}

TEST_F(ContactImpulsesTest, OfOverlapThatGrewOnlyTheGrowthIsMotion) {
  heights(0, -0.0005, -0.0012);
  hold({1, 0, 0});
  apply();
  EXPECT_NEAR(positions[0].y(), 0, kExact);
  EXPECT_NEAR(motion(0), 0.0007, kExact) << "the mass comes to rest";
}

TEST_F(ContactImpulsesTest, AMassThatLeavesIsNotTouched) {
  heights(0, -0.0005, 0.0001);
  hold({1, 0, 0});
  apply();
  EXPECT_EQ(positions[0].y(), 0.0001);
  EXPECT_EQ(motion(0), 0);
  EXPECT_EQ(total(), Vec3::Zero());
}

// Two masses, one contact in their middle: d m_j w_j im_j / sum(im w^2), lambda = d / sum(im w^2).
TEST_F(ContactImpulsesTest, AContactBetweenTwoMassesSharesByInverseMass) {
  heights(0, 0.001, -0.0006);
  heights(1, 0.001, -0.0006);
  hold({0.5, 0.5, 0});
  apply();
  const double push = 0.0006 / (10 * 0.25 + 20 * 0.25);
  EXPECT_NEAR(motion(0), push * 10 * 0.5, kExact);
  EXPECT_NEAR(motion(1), push * 20 * 0.5, kExact);
  EXPECT_NEAR(total().y(), push, kExact);
}

// The contact between the masses acts first, then the one at mass 0 makes it needless: what it pushed is
// taken back, mass 1 ends where it was.
TEST_F(ContactImpulsesTest, WhatAnotherContactMakesNeedlessIsTakenBack) {
  heights(0, 0.001, -0.001);
  heights(1, 0.001, 0.001);
  constraints.clear();
  hold({0.6, 0.4, 0});  // its point is at -0.2 mm; with mass 0 at the face at +0.4 mm
  hold({1, 0, 0});
  apply(0, 100);
  EXPECT_NEAR(positions[0].y(), 0, 1e-12);
  EXPECT_NEAR(positions[1].y(), 0.001, 1e-12);
  EXPECT_NEAR(total().y(), 0.1 * 0.001, 1e-12);
}

TEST_F(ContactImpulsesTest, AFixedVertexStays) {
  heights(2, -0.001, -0.001);
  hold({0, 0, 1});
  apply();
  EXPECT_EQ(positions[2].y(), -0.001);
  EXPECT_EQ(total(), Vec3::Zero());
}

// Any contacts: the momentum that the tissue gets is what the contacts say they gave, and none pulls.
TEST(ContactImpulses, MomentumBalancesForAnyContacts) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> spread(-1, 1);
  const auto vector = [&] { return Vec3(spread(random), spread(random), spread(random)); };
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec3> before(12), positions(12);
    std::vector<double> inverse_masses(12);
    for (int v = 0; v < 12; ++v) {
      before[v] = 0.01 * vector();
      positions[v] = before[v] + 0.002 * vector();
      inverse_masses[v] = 20 + 10 * spread(random);
    }
    std::vector<ContactConstraint> constraints;
    for (int c = 0; c < 15; ++c) {
      const double a = 0.3 + 0.2 * spread(random), b = 0.3 + 0.2 * spread(random);
      constraints.push_back({.vertices = {c % 12, (c + 3) % 12, (c + 7) % 12},
                             .weights = {a, b, 1 - a - b},
                             .position_m = 0.005 * vector(),
                             .normal = vector().normalized(),
                             .target_m = 0.0005});
    }
    std::vector<ToolBody> bodies;
    if (trial % 2 == 1) {
      bodies = {{.inverse_mass_1_kg = 30}};
      for (ContactConstraint& contact : constraints) contact.friction = 0.4;
    }
    ContactImpulses impulses(12, 30);
    const std::vector<ToolState> was = {{.pose = {.position_m = 0.001 * vector()}}};
    const std::vector<ToolState> is(1);
    impulses.apply(constraints, inverse_masses,
                   {.positions_m = positions,
                    .before_m = before,
                    .tools_before = was,
                    .tools_now = is,
                    .tool_bodies = bodies});
    Vec3 given = Vec3::Zero();
    for (int v = 0; v < 12; ++v) given += impulses.motion_m()[v] / inverse_masses[v];
    ASSERT_NEAR((given - impulses.total(std::vector<double>(12, 1.0))).norm(), 0,
                1e-14 * std::max(1.0, given.norm()));
    ASSERT_GT(given.norm(), 1e-6) << "no contact, no test";
    for (const ToolBody& body : bodies)
      ASSERT_NEAR((given + body.motion_m / body.inverse_mass_1_kg).norm(), 0,
                  1e-14 * std::max(1.0, given.norm()))
          << "what tissue gains the tool loses";
  }
}

}  // namespace
}  // namespace fissure::contact_impulses_test
