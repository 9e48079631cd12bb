#include "motion/virtual_coupling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fissure::virtual_coupling_test {

namespace {

constexpr CouplingSettings kHeavy{.mass_kg = 0.05, .stiffness_N_m = 500, .damping_N_s_m = 2, .force = {}};

/// Of the tool after 20 ms under 0.5 N, the hand at rest.
double wayAfterAStep(double step_s) {
  VirtualCoupling coupling(kHeavy, Vec3::Zero(), step_s);
  Vec3 at = Vec3::Zero();
  const int steps = static_cast<int>(std::lround(0.02 / step_s));
  for (int i = 0; i < steps; ++i) at = coupling.advance(Vec3::Zero(), Vec3(0.5, 0, 0));
  return at.x();
}

// Under a constant force F: x = F/k (1 - exp(-s t) (cos(w t) + s/w sin(w t))), s = c/2m, w^2 = k/m - s^2.
TEST(VirtualCoupling, SwingsAsAnOscillatorDoesToTheFirstOrderOfTheStep) {
  const double s = kHeavy.damping_N_s_m / (2 * kHeavy.mass_kg);
  const double w = std::sqrt(kHeavy.stiffness_N_m / kHeavy.mass_kg - s * s);
  const double t = 0.02;
  const double exact =
      0.5 / kHeavy.stiffness_N_m * (1 - std::exp(-s * t) * (std::cos(w * t) + s / w * std::sin(w * t)));
  double before = 0;
  for (const double step_s : {1e-4, 5e-5, 2.5e-5}) {
    const double error = std::abs(wayAfterAStep(step_s) - exact);
    EXPECT_LT(error, 0.3 * step_s / 1e-4 * exact);
    if (before > 0) {
      EXPECT_NEAR(before / error, 2, 0.1);
    }
    before = error;
  }
}

// A hand that goes on at a tenth of its speed, and the tool with it: without that it flies on.
TEST(VirtualCoupling, SlowsDownWithItsHand) {
  VirtualCoupling coupling(kHeavy, Vec3::Zero(), 0.001);
  Vec3 at, before;
  for (int i = 1; i <= 3000; ++i) {
    before = at;
    at = coupling.advance(Vec3(0.001 * i, 0, 0), Vec3::Zero());
  }
  EXPECT_NEAR((at - before).x(), 0.001, 1e-9);
  coupling.changeTempo(10);
  VirtualCoupling slower = coupling;
  slower.changeTempo(0.1);
  const Vec3 target_m(3.0001, 0, 0);
  EXPECT_NEAR((slower.advance(target_m, Vec3::Zero()) - at).x(), 0.0001, 2e-5);
  EXPECT_NEAR((coupling.advance(target_m, Vec3::Zero()) - at).x(), 0.001, 1e-4);
}

TEST(VirtualCoupling, AtRestTheSpringHoldsTheForce) {
  VirtualCoupling coupling(kHeavy, Vec3(0.1, 0, 0), 0.001);
  Vec3 at;
  for (int i = 0; i < 5000; ++i) at = coupling.advance(Vec3(0.1, 0, 0), Vec3(0, 0.5, 0));
  EXPECT_LT((at - Vec3(0.1, 0.001, 0)).norm(), 1e-12);
  EXPECT_LT((coupling.force_on_tool_N() - Vec3(0, -0.5, 0)).norm(), 1e-9);
}

// Spring and damper hold the tool to the hand, not to a place: at one speed nothing pulls.
TEST(VirtualCoupling, BehindAHandOfConstantSpeedNothingIsLeftOfTheLag) {
  VirtualCoupling coupling(kHeavy, Vec3::Zero(), 0.001);
  Vec3 at, hand;
  for (int i = 1; i <= 5000; ++i) {
    hand = Vec3(0.0001 * i, 0, 0);
    at = coupling.advance(hand, Vec3::Zero());
  }
  EXPECT_LT((at - hand).norm(), 1e-12);
  EXPECT_LT(coupling.force_on_tool_N().norm(), 1e-9);
}

/// What a contact does that holds the tool where it is, hand at rest 0.1 m away.
struct Held {
  VirtualCoupling coupling{kHeavy, Vec3::Zero(), 0.001};
  Vec3 impulse_N_s;

  void step() {
    const Vec3 free_m = coupling.advance(Vec3(0.1, 0, 0), Vec3::Zero());
    impulse_N_s = -free_m / 0.001 / coupling.inverseMass_1_kg();
    coupling.push(Vec3::Zero(), Vec3::Zero());
  }
};

TEST(VirtualCoupling, HeldByContactsTheSpringGivesWhatTheyTake) {
  Held held;
  for (int i = 0; i < 3; ++i) {
    held.step();
    if (i == 0) continue;  // the hand was not at rest in the first step
    EXPECT_LT((held.coupling.force_on_tool_N() - Vec3(0.1 * kHeavy.stiffness_N_m, 0, 0)).norm(), 1e-9);
    EXPECT_LT((held.impulse_N_s + 0.001 * held.coupling.force_on_tool_N()).norm(), 1e-12);
  }
}

// An impulse J in a step: the change of momentum is J and what spring and damper gave.
TEST(VirtualCoupling, APushAndTheForceAreTheChangeOfMomentum) {
  VirtualCoupling coupling(kHeavy, Vec3::Zero(), 0.001);
  Vec3 at_m = Vec3::Zero(), velocity_m_s = Vec3::Zero();
  for (int i = 1; i <= 100; ++i) {
    const Vec3 before_m_s = velocity_m_s, impulse_N_s(0.001 * std::sin(i), 0, 0.002);
    const Vec3 free_m = coupling.advance(Vec3(0, 1e-4 * i, 0), Vec3::Zero());
    const Vec3 change_m_s = coupling.inverseMass_1_kg() * impulse_N_s;
    velocity_m_s = (free_m - at_m) / 0.001 + change_m_s;
    at_m = free_m + 0.001 * change_m_s;
    coupling.push(at_m, velocity_m_s);
    const Vec3 momentum_N_s = kHeavy.mass_kg * (velocity_m_s - before_m_s);
    ASSERT_LT((momentum_N_s - impulse_N_s - 0.001 * coupling.force_on_tool_N()).norm(), 1e-14) << i;
    const Vec3 lag_m = Vec3(0, 1e-4 * i, 0) - at_m, lags_m_s = Vec3(0, 0.1, 0) - velocity_m_s;
    ASSERT_LT(
        (kHeavy.stiffness_N_m * lag_m + kHeavy.damping_N_s_m * lags_m_s - coupling.force_on_tool_N()).norm(),
        1e-10)
        << i;
  }
}

TEST(VirtualCoupling, AStiffOneIsStableAndFollowsTheHand) {
  VirtualCoupling coupling({.mass_kg = 0.01, .stiffness_N_m = 1e9, .damping_N_s_m = 0, .force = {}},
                           Vec3::Zero(), 0.001);
  for (int i = 1; i <= 1000; ++i) {
    const Vec3 hand(std::sin(0.01 * i), 0, 0);
    ASSERT_LT((coupling.advance(hand, Vec3(0, 5, 0)) - hand).norm(), 1e-6) << i;
    EXPECT_EQ(coupling.target_m(), hand);
  }
  VirtualCoupling rigid({.mass_kg = 0.01, .stiffness_N_m = 1e300, .damping_N_s_m = 0, .force = {}},
                        Vec3::Zero(), 0.001);
  rigid.advance(Vec3::Zero(), Vec3(0, 5, 0));
  EXPECT_EQ(rigid.force_on_tool_N(), Vec3(0, -5, 0));
}

}  // namespace
}  // namespace fissure::virtual_coupling_test
