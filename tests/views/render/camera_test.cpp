#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "mesh/primitives.h"

namespace fissure::camera_test {

namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

/// 90 degrees high, 1 m in front of the origin: at the origin half the height is 1 m.
Camera squareCamera() {
  CameraSettings settings;
  settings.position_m = {0, 0, 1};
  settings.look_at_m = {0, 0, 0};
  settings.field_of_view_deg = 90;
  return makeCamera(settings, 400, 200);
}

TEST(Camera, ProjectsInClosedForm) {
  const Camera camera = squareCamera();
  const auto middle = camera.project({0, 0, 0});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x_px, 200, 1e-9);
  EXPECT_NEAR(middle->y_px, 100, 1e-9);
  EXPECT_NEAR(middle->depth_m, 1, 1e-12);
  // 1 m is half the height, 100 pixels; twice as deep, half as large. Up in the scene is up in the picture.
  const auto corner = camera.project({1, 0.5, 0});
  EXPECT_NEAR(corner->x_px, 300, 1e-9);
  EXPECT_NEAR(corner->y_px, 50, 1e-9);
  const auto deep = camera.project({1, 0.5, -1});
  EXPECT_NEAR(deep->x_px, 250, 1e-9);
  EXPECT_NEAR(deep->y_px, 75, 1e-9);
  EXPECT_NEAR(camera.pixelSize_m(1), 0.01, 1e-12);
}

TEST(Camera, SeesNothingBehindOrTooNear) {
  const Camera camera = squareCamera();
  EXPECT_FALSE(camera.project({0, 0, 2}));
  EXPECT_FALSE(camera.project({0, 0, 1 - 0.99 / 50}));
  EXPECT_TRUE(camera.project({0, 0, 1 - 1.01 / 50}));
  EXPECT_FALSE(camera.project({nan, 0, nan}));
}

TEST(Camera, AxesAreRightHandedForAnyUp) {
  for (const Vec3& up : {Vec3(0, 1, 0), Vec3(0.3, 0.4, -5), Vec3(1, 2, 3), Vec3(0, 0, 0)}) {
    CameraSettings settings;
    settings.position_m = {1, 2, 3};  // looking at the origin: the third `up` is parallel to the view
    settings.up = up;
    const Camera camera = makeCamera(settings, 64, 48);
    EXPECT_NEAR((camera.back - Vec3(1, 2, 3).normalized()).norm(), 0, 1e-12);
    EXPECT_NEAR((camera.right.cross(camera.up) - camera.back).norm(), 0, 1e-12);
    EXPECT_NEAR(camera.right.norm(), 1, 1e-12);
    EXPECT_NEAR(camera.right.dot(camera.back), 0, 1e-12);
  }
  CameraSettings upright;
  upright.position_m = {0, 1, 0};  // straight down, up along the view
  EXPECT_NEAR(makeCamera(upright, 64, 48).right.norm(), 1, 1e-12);
}

TEST(Camera, ItsSettingsMakeItAgain) {
  const CameraSettings settings{{0.1, 0.3, 0.5}, {0.02, -0.03, 0.04}, {0.2, 1, 0.1}, 42};
  const Camera camera = makeCamera(settings, 64, 48);
  const CameraSettings found = settingsOf(camera);
  EXPECT_EQ(found.position_m, settings.position_m);
  EXPECT_NEAR((found.look_at_m - settings.look_at_m).norm(), 0, 1e-15);
  EXPECT_NEAR(found.field_of_view_deg, 42, 1e-12);
  const Camera again = makeCamera(found, 64, 48);
  EXPECT_NEAR((again.right - camera.right).norm() + (again.up - camera.up).norm(), 0, 1e-14);
}

TEST(Camera, OfAScenarioIsItsOwnOrTheDefault) {
  const std::vector<Vec3> points_m = {{0, 0, 0}, {0.1, 0.1, 0.1}};
  FrameSettings frames;
  EXPECT_EQ(frameCamera(frames, points_m).position_m, defaultCamera(points_m, 640, 480).position_m);
  EXPECT_GT(defaultCamera(points_m, 640, 480, 10).focus_m,
            1.5 * defaultCamera(points_m, 640, 480, 20).focus_m)
      << "a narrower view is from farther off";
  frames.camera = CameraSettings{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 35};
  frames.width_px = 100;
  EXPECT_EQ(frameCamera(frames, points_m).position_m, Vec3(1, 2, 3));
  EXPECT_EQ(frameCamera(frames, points_m).width_px, 100);
}

TEST(Camera, RefusesToLookAtItself) {
  CameraSettings settings;
  settings.position_m = settings.look_at_m = {0.1, 0.2, 0.3};
  EXPECT_THROW(makeCamera(settings, 64, 48), InputError);
}

TEST(Camera, MatricesAgreeWithProject) {
  CameraSettings settings;
  settings.position_m = {0.1, 0.2, 0.3};
  settings.look_at_m = {0.01, -0.02, 0.03};
  const Camera camera = makeCamera(settings, 321, 123);
  for (const Vec3& point_m : {Vec3(0, 0, 0), Vec3(0.03, 0.01, -0.02), Vec3(-0.05, 0.06, 0.1)}) {
    const Eigen::Vector4d clip = camera.projectionMatrix() * camera.viewMatrix() * point_m.homogeneous();
    const auto at = camera.project(point_m);
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->x_px, (1 + clip.x() / clip.w()) * 321 / 2, 1e-9);
    EXPECT_NEAR(at->y_px, (1 - clip.y() / clip.w()) * 123 / 2, 1e-9);
    const double stored = (1 + clip.z() / clip.w()) / 2;
    EXPECT_NEAR(camera.depthFromStored(stored), at->depth_m, 1e-9);
  }
  EXPECT_NEAR(camera.depthFromStored(0), camera.near_m(), 1e-12);
  EXPECT_NEAR(camera.depthFromStored(1), camera.far_m(), 1e-9);
}

TEST(FitCamera, HoldsAllPointsAndTouchesOpposedEdges) {
  const Camera oblique = makeCamera({{0.5, 0.7, 0.9}, {0, 0, 0}, {0, 1, 0}, 40}, 640, 480);
  const std::vector<std::vector<Vec3>> clouds = {
      {{0, 0, 0}, {0.1, 0, 0}, {0, 0.02, 0.3}},  // wide
      {{5, 5, 5}, {5, 5.4, 5}, {5.01, 5.2, 5}},  // high, far from the origin
      makeSphere(0.03, 2).vertices_m};
  for (const std::vector<Vec3>& points_m : clouds) {
    const Camera camera = fitCamera(oblique, points_m, 0.8);
    double left = 1, right = -1, bottom = 1, top = -1;
    for (const Vec3& point_m : points_m) {
      const auto at = camera.project(point_m);
      ASSERT_TRUE(at);
      left = std::min(left, 2 * at->x_px / 640 - 1);
      right = std::max(right, 2 * at->x_px / 640 - 1);
      bottom = std::min(bottom, 1 - 2 * at->y_px / 480);
      top = std::max(top, 1 - 2 * at->y_px / 480);
    }
    // The extreme sides of the tighter direction both lie at 80 %, the other's within.
    EXPECT_GE(std::min(left, bottom), -0.8 - 1e-9);
    EXPECT_LE(std::max(right, top), 0.8 + 1e-9);
    const double slack_x = std::max(left + 0.8, 0.8 - right);
    const double slack_y = std::max(bottom + 0.8, 0.8 - top);
    EXPECT_NEAR(std::min(slack_x, slack_y), 0, 1e-9);
    EXPECT_GT(camera.focus_m, 0);
  }
}

Scene sphereAndTool() {
  Scene scene;
  SceneBody body;
  body.rest = makeSphere(0.03, 1);
  scene.bodies.push_back(body);
  SceneTool tool;
  tool.surface = makeBox({0.04, 0.002, 0.015});
  scene.tools.push_back(tool);
  return scene;
}

State firstState(const Scene& scene) {
  State state;
  state.positions_m = scene.bodies.empty() ? std::vector<Vec3>{} : scene.bodies[0].rest.vertices_m;
  state.tools.resize(scene.tools.size());
  for (ToolState& tool : state.tools) {
    tool.pose.position_m = {0, 0.05, 0};
  }
  return state;
}

TEST(DefaultCamera, StandsInFrontAboveAndToTheRight) {
  const Scene scene = sphereAndTool();
  const State first = firstState(scene);
  const Camera camera = defaultCamera(pointsInView(scene, first), 640, 480);
  EXPECT_NEAR(std::asin(camera.back.y()) * 180 / M_PI, 20, 1e-9);
  EXPECT_NEAR(std::atan2(camera.back.x(), camera.back.z()) * 180 / M_PI, 25, 1e-9);
  EXPECT_GT(camera.up.y(), 0.9);
  for (const Vec3& point_m : pointsInView(scene, first)) {
    const auto at = camera.project(point_m);
    ASSERT_TRUE(at);
    EXPECT_TRUE(at->x_px > 0 && at->x_px < 640 && at->y_px > 0 && at->y_px < 480);
  }
}

TEST(PointsInView, HoldsBodiesToolsAndNearGround) {
  Scene scene = sphereAndTool();
  const State first = firstState(scene);
  EXPECT_EQ(pointsInView(scene, first).size(), 18u + 8u);
  scene.ground_height_m = -0.04;  // 10 mm below the sphere: its four corners belong to the picture
  const std::vector<Vec3> with_ground = pointsInView(scene, first);
  ASSERT_EQ(with_ground.size(), 18u + 8u + 4u);
  EXPECT_EQ(with_ground.back().y(), -0.04);
  scene.ground_height_m = -5;  // far below: the scene would be a dot
  EXPECT_EQ(pointsInView(scene, first).size(), 18u + 8u);
}

TEST(PointsInView, LeavesOutWhatCannotBeDrawn) {
  const Scene scene = sphereAndTool();
  State first = firstState(scene);
  first.positions_m[3] = {nan, 0, 0};
  first.positions_m[4] = {0, 1e200, 0};
  first.tools[0].pose.position_m.x() = nan;
  EXPECT_EQ(pointsInView(scene, first).size(), 16u);
  for (Vec3& position_m : first.positions_m) {
    position_m.setConstant(nan);
  }
  const Camera camera =
      defaultCamera(pointsInView(scene, first), 640, 480);  // nothing left: 0.1 m around the origin
  EXPECT_TRUE(camera.position_m.allFinite());
  EXPECT_TRUE(camera.project({0.05, 0.05, 0.05}));
}

}  // namespace
}  // namespace fissure::camera_test
