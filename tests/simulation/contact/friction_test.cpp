// Coulomb friction of ContactImpulses, against closed forms. contact/METHOD.md 6.1.
#include <gtest/gtest.h>

#include <random>

#include "contact/contact_impulses.h"

namespace fissure::friction_test {

namespace {

constexpr double kExact = 1e-15;

/// One mass of 0.1 kg on a tool whose upper face is at y = 0 and whose friction is 0.5.
class FrictionTest : public testing::Test {
 protected:
  /// The mass starts the step at `from_m`, is predicted at `to_m`; the tool comes from `tool_was`.
  void step(const Vec3& from_m, const Vec3& to_m, const Pose& tool_was = {}) {
    before[0] = from_m;
    positions[0] = to_m;
    const std::vector<ToolState> was = {{.pose = tool_was}}, is(1);
    impulses.apply(constraints, std::vector<double>{10},
                   {.positions_m = positions, .before_m = before, .tools_before = was, .tools_now = is});
  }
  Vec3 motion_m() const { return impulses.motion_m()[0]; }
  Vec3 total() const { return impulses.total(std::vector<double>{1}); }

  std::vector<Vec3> before{Vec3::Zero()}, positions{Vec3::Zero()};
  std::vector<ContactConstraint> constraints{{.vertices = {0, 0, 0},
                                              .weights = {1, 0, 0},
                                              .position_m = Vec3::Zero(),
                                              .normal = Vec3(0, 1, 0),
                                              .friction = 0.5}};
  ContactImpulses impulses{1, 30};
};

void expectNear(const Vec3& found, const Vec3& expected, double tolerance = kExact) {
  EXPECT_NEAR((found - expected).norm(), 0, tolerance) << found.transpose();
}

TEST_F(FrictionTest, WhatTheConeHoldsSticks) {
  step(Vec3::Zero(), Vec3(0.0003, -0.001, 0.0003));  // 0.42 mm aside, at most 0.5 mm are held
  expectNear(positions[0], Vec3::Zero());
  expectNear(motion_m(), Vec3(-0.0003, 0.001, -0.0003));
  expectNear(total(), 0.1 * motion_m());
}

// A cone, not a pyramid: 3 and 4 mm aside, the share of 1 mm against it is 0.3 and 0.4 mm.
TEST_F(FrictionTest, WhatSlidesIsSlowedByItsShareOfThePush) {
  step(Vec3::Zero(), Vec3(0.003, -0.002, 0.004));
  expectNear(positions[0], Vec3(0.0024, 0, 0.0032));
  expectNear(total(), 0.1 * Vec3(-0.0006, 0.002, -0.0008));
}

TEST_F(FrictionTest, WithoutAPushNothingRubs) {
  step(Vec3::Zero(), Vec3(0.003, 0.0001, 0));
  EXPECT_EQ(positions[0], Vec3(0.003, 0.0001, 0));
  EXPECT_EQ(total(), Vec3::Zero());
}

TEST_F(FrictionTest, AToolTakesAlongWhatRestsOnIt) {
  step(Vec3::Zero(), Vec3(0, -0.001, 0), {.position_m = Vec3(-0.0004, 0, 0)});
  expectNear(positions[0], Vec3(0.0004, 0, 0));
  step(Vec3::Zero(), Vec3(0, -0.001, 0), {.position_m = Vec3(-0.0008, 0, 0)});
  expectNear(positions[0], Vec3(0.0005, 0, 0));  // slides behind
}

TEST_F(FrictionTest, ATurningToolTakesAlongWhatRestsOnIt) {
  const Quat turn(Eigen::AngleAxisd(0.01, Vec3::UnitY()));
  const Vec3 was_m(0.05, 0, 0);
  step(was_m, was_m - Vec3(0, 0.001, 0), {.orientation = turn.conjugate()});
  expectNear(positions[0], turn * was_m);
}

TEST_F(FrictionTest, OldOverlapRubsWithoutMotion) {
  step(Vec3(0, -0.0005, 0), Vec3(0.0001, -0.0005, 0));  // nothing approached: no force, no friction
  EXPECT_NEAR(positions[0].y(), 0, kExact);
  expectNear(motion_m(), Vec3::Zero());
  expectNear(total(), Vec3::Zero());
}

TEST_F(FrictionTest, OfOverlapThatGrewOnlyTheGrowthRubs) {
  step(Vec3(0, -0.0005, 0), Vec3(0.001, -0.0007, 0));
  expectNear(motion_m(), Vec3(-0.0001, 0.0002, 0));
}

// What is forgotten of a push may round to a little more than it was.
TEST(Friction, APushForgottenAsAWholeLeavesNumbers) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> spread(0.1, 0.4);
  for (int trial = 0; trial < 2000; ++trial) {
    const double a = spread(random), b = spread(random);
    const std::vector<Vec3> before(3, Vec3(0, -0.001 * spread(random), 0));
    std::vector<Vec3> positions = before;
    const ContactConstraint contact{.vertices = {0, 1, 2},
                                    .weights = {a, b, 1 - a - b},
                                    .position_m = Vec3::Zero(),
                                    .normal = Vec3(0, 1, 0),
                                    .friction = 0.5};
    ContactImpulses impulses(3, 30);
    const std::vector<ToolState> resting(1);
    impulses.apply(
        std::vector{contact}, std::vector<double>(3, 100 * spread(random)),
        {.positions_m = positions, .before_m = before, .tools_before = resting, .tools_now = resting});
    for (const Vec3& motion_m : impulses.motion_m()) ASSERT_NEAR(motion_m.norm(), 0, kExact);
    ASSERT_NEAR(impulses.total(std::vector<double>(3, 1)).norm(), 0, kExact);
  }
}

// Put into a groove of two faces, at rest: pushed out of both, and at rest still.
TEST_F(FrictionTest, OldOverlapInAGrooveThrowsNothing) {
  constraints.push_back(constraints[0]);
  constraints[0].normal = Vec3(1, 2, 0).normalized();
  constraints[1].normal = Vec3(-1, 3, 0.5).normalized();
  step(Vec3(0, -0.0005, 0), Vec3(0, -0.0005, 0));
  EXPECT_GT(positions[0].y(), -1e-5);
  expectNear(motion_m(), Vec3::Zero(), 1e-12);
}

// Any contacts: momentum balances, no contact rubs by more than its share (seen where all normals are one),
// and the world turned or mirrored gives the same turned or mirrored.
class AnyContacts : public testing::Test {
 protected:
  static constexpr int kVertices = 12;
  struct Result {
    std::vector<Vec3> positions, motion;
    Vec3 total;
  };

  AnyContacts() {
    for (int v = 0; v < kVertices; ++v) {
      before.push_back(0.01 * vector());
      predicted.push_back(before[v] + 0.002 * vector());
      inverse_masses.push_back(20 + 10 * spread(random));
    }
    for (int c = 0; c < 15; ++c) {
      const double a = 0.3 + 0.2 * spread(random), b = 0.3 + 0.2 * spread(random);
      constraints.push_back({.vertices = {c % 12, (c + 3) % 12, (c + 7) % 12},
                             .weights = {a, b, 1 - a - b},
                             .position_m = 0.005 * vector(),
                             .normal = vector().normalized(),
                             .target_m = 0.0005,
                             .friction = 0.4});
    }
    tool_was = {.position_m = 0.001 * vector(),
                .orientation = Quat(Eigen::AngleAxisd(0.01, vector().normalized()))};
  }
  Vec3 vector() { return {spread(random), spread(random), spread(random)}; }

  /// Everything transformed by an orthogonal matrix.
  Result apply(const Mat3& turn = Mat3::Identity()) const {
    const auto turned = [&](std::vector<Vec3> points) {
      for (Vec3& p : points) p = turn * p;
      return points;
    };
    std::vector<ContactConstraint> contacts = constraints;
    for (ContactConstraint& c : contacts) {
      c.position_m = turn * c.position_m;
      c.normal = turn * c.normal;
    }
    const Mat3 was = turn * tool_was.orientation.toRotationMatrix() * turn.transpose();
    const ToolState tool{.pose = {.position_m = turn * tool_was.position_m, .orientation = Quat(was)}};
    Result result{.positions = turned(predicted)};
    ContactImpulses impulses(kVertices, 30);
    const std::vector<Vec3> turned_before = turned(before);
    const std::vector<ToolState> tools_before = {tool}, tools_now(1);
    impulses.apply(contacts, inverse_masses,
                   {.positions_m = result.positions,
                    .before_m = turned_before,
                    .tools_before = tools_before,
                    .tools_now = tools_now});
    result.motion.assign(impulses.motion_m().begin(), impulses.motion_m().end());
    result.total = impulses.total(std::vector<double>(kVertices, 1.0));
    return result;
  }

  std::mt19937 random{11};
  std::uniform_real_distribution<double> spread{-1, 1};
  std::vector<Vec3> before, predicted;
  std::vector<double> inverse_masses;
  std::vector<ContactConstraint> constraints;
  Pose tool_was;
};

TEST_F(AnyContacts, MomentumBalances) {
  const Result result = apply();
  Vec3 given = Vec3::Zero();
  for (int v = 0; v < kVertices; ++v) given += result.motion[v] / inverse_masses[v];
  EXPECT_GT(given.norm(), 1e-5) << "no contact, no test";
  expectNear(given, result.total, 1e-14 * std::max(1.0, given.norm()));
}

TEST_F(AnyContacts, AFixedVertexStays) {
  inverse_masses[5] = 0;
  const Result result = apply();
  EXPECT_EQ(result.positions[5], predicted[5]);
  EXPECT_EQ(result.motion[5], Vec3::Zero());
}

TEST_F(AnyContacts, AllOfOneNormalRubByAtMostTheirShare) {
  for (ContactConstraint& c : constraints) c.normal = Vec3::UnitY();
  const Vec3 total = apply().total;
  EXPECT_GT(total.y(), 1e-5);
  EXPECT_LE(std::hypot(total.x(), total.z()), 0.4 * total.y() * (1 + 1e-12));
}

TEST_F(AnyContacts, TurnedAndMirroredWorldsAgree) {
  const Result result = apply();
  const Mat3 turn = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).toRotationMatrix();
  for (const Mat3& matrix : {turn, Mat3(Vec3(-1, 1, 1).asDiagonal()), Mat3(-turn)}) {
    const Result other = apply(matrix);
    for (int v = 0; v < kVertices; ++v) {
      expectNear(other.positions[v], matrix * result.positions[v], 1e-14);
      expectNear(other.motion[v], matrix * result.motion[v], 1e-14);
    }
    expectNear(other.total, matrix * result.total, 1e-14);
  }
}

}  // namespace
}  // namespace fissure::friction_test
