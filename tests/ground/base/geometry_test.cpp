#include "base/geometry.h"

#include <gtest/gtest.h>

#include <numbers>

namespace fissure::geometry_test {

namespace {

TEST(Pose, MapsBetweenBodyAndScene) {
  // A quarter turn about z, then 1 m along x: the body's x axis is the scene's y axis.
  const Pose pose{.position_m = Vec3(1, 0, 0),
                  .orientation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()))};
  EXPECT_NEAR((pose.toScene(Vec3(2, 0, 0)) - Vec3(1, 2, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((pose.rotateToScene(Vec3(2, 0, 0)) - Vec3(0, 2, 0)).norm(), 0, 1e-15);
  const Vec3 point(0.3, -0.2, 0.7);
  EXPECT_NEAR((pose.toBody(pose.toScene(point)) - point).norm(), 0, 1e-15);
  EXPECT_NEAR((pose.rotateToBody(pose.rotateToScene(point)) - point).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace fissure::geometry_test
