#include "engine/pose_matching.h"

#include <gtest/gtest.h>

#include "engine/simulation.h"
#include "engine/soft_body.h"
#include "mesh/primitives.h"
#include "scene/place.h"

namespace fissure::pose_matching_test {

namespace {

BodySettings sphere(double radius_m, double pose_matching) {
  BodySettings body;
  body.name = "sphere";
  body.shape = SphereShape{.radius_m = radius_m, .subdivisions = 3};
  body.mass_kg = 0.1;
  body.material.linear_stiffness = 0.5;
  body.solver.pose_matching = pose_matching;
  body.solver.position_iterations = 10;
  return body;
}

bool isNeeded(const BodySettings& settings) {
  btSoftBodyWorldInfo info;
  const PipelineSettings pipeline{.name = "null", .pipeline = PipelineKind::null_sdf};
  return PoseMatching::isNeededFor(*makeSoftBody(info, placeBody(settings), settings, pipeline));
}

/// Extent over extent at rest, along x, after 50 steps in which nothing acts.
double shareKept(double radius_m) {
  Scenario scenario;
  scenario.time.step_s = 0.001;
  scenario.world.gravity_m_s2 = Vec3::Zero();
  scenario.bodies = {sphere(radius_m, 0.2)};
  Scene scene;
  scene.bodies.push_back({.name = "sphere", .rest = placeBody(scenario.bodies[0])});
  const auto simulation =
      makeSimulation(scenario, {.name = "null", .pipeline = PipelineKind::null_sdf}, scene, {});
  for (int step = 0; step < 50; ++step) simulation->step({});
  double extent_m = 0;
  for (const Vec3& position_m : simulation->state().positions_m)
    extent_m = std::max(extent_m, position_m.x());
  return extent_m / radius_m;
}

}  // namespace

TEST(PoseMatching, IsNeededOnlyWhereBulletsOwnCouldCollapseTheBody) {
  EXPECT_FALSE(isNeeded(sphere(0.03, 0.02)));
  EXPECT_FALSE(isNeeded(sphere(0.001, 0.02)));
  EXPECT_TRUE(isNeeded(sphere(0.0001, 0.02)));
  EXPECT_FALSE(isNeeded(sphere(0.0001, 0))) << "not matched at all";
}

// Bullet's own draws a sphere of a tenth of a millimetre to a point, in double precision; in single precision
// one of 30 mm (Run.SinglePrecisionKeepsTheTissuesSize).
TEST(PoseMatching, KeepsASmallBodysSize) {
  EXPECT_NEAR(shareKept(0.03), 1, 1e-6);
  EXPECT_NEAR(shareKept(0.0001), 1, 1e-6);
}

// Turned, moved and stretched: a hundredth of the size does what Bullet does, a hundredth as large.
TEST(PoseMatching, DrawsToTheTurnedRestShapeAsBulletDoes) {
  const PipelineSettings pipeline{.name = "null", .pipeline = PipelineKind::null_sdf};
  btSoftBodyWorldInfo info;
  info.m_gravity = btVector3(0, 0, 0);
  const auto drawn = [&](double radius_m, bool ours) {
    const BodySettings settings = sphere(radius_m, 0.2);
    auto body = makeSoftBody(info, placeBody(settings), settings, pipeline);
    const btMatrix3x3 turn(btQuaternion(btVector3(1, 2, 3).normalized(), btScalar(0.7)));
    for (int i = 0; i < body->m_nodes.size(); ++i) {
      btVector3& x = body->m_nodes[i].m_x;
      x = turn * (btVector3(btScalar(1.2), 1, btScalar(0.9)) * x) + btVector3(2, 3, 4) * btScalar(radius_m);
    }
    if (ours) {
      const PoseMatching matching(*body);
      body->predictMotion(btScalar(0.001));
      matching.apply();
    } else {
      body->predictMotion(btScalar(0.001));
    }
    std::vector<Vec3> shape;
    for (int i = 0; i < body->m_nodes.size(); ++i) {
      const btVector3 x = body->m_nodes[i].m_x / btScalar(radius_m);
      shape.emplace_back(x.x(), x.y(), x.z());
    }
    return shape;
  };
  const std::vector<Vec3> small = drawn(0.0001, true), bullets = drawn(0.01, false);
  ASSERT_EQ(small.size(), bullets.size());
  for (std::size_t i = 0; i < small.size(); ++i) EXPECT_LT((small[i] - bullets[i]).norm(), 1e-9) << i;
}

}  // namespace fissure::pose_matching_test
