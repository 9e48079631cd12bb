// Penetration over many steps: what is kept from step to step changes nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "surface/crossing.h"
#include "surface/oracles.h"
#include "surface/winding.h"

namespace fissure::following_test {

namespace {

const Vec3 kBlade(0.04, 0.002, 0.015);
constexpr double kSpacing_m = 0.004;

/// Samples that passed through a body, every one looked at in every step.
class EagerPassages {
 public:
  EagerPassages(const Scene& scene, std::size_t tool, std::size_t body)
      : samples_(makeToolSamples(scene, scene.tools[tool], kSpacing_m)),
        surface_(scene.bodies[body].rest),
        passage_(samples_.points_m.size()),
        passed_(samples_.points_m.size(), 0) {}

  void step(std::span<const Vec3> vertices_m, const Pose& pose) {
    surface_.update(vertices_m);
    if (first_) surface_.forgetMotion();
    if (first_) before_ = pose;
    first_ = false;
    const auto place = [&](const Pose& at, std::size_t i) {
      return Vec3((SurfaceTree::frame() * at.orientation.toRotationMatrix()) * samples_.points_m[i] +
                  SurfaceTree::toTree(at.position_m));
    };
    for (std::size_t i = 0; i < passed_.size(); ++i) {
      const Vec3 now = place(pose, i);
      findCrossings(surface_, place(before_, i), now, crossings_);
      if (passage_.advance(i, crossings_, windingNumber(surface_, now) > 0)) passed_[i] = 1;
    }
    before_ = pose;
  }
  const std::vector<char>& passed() const { return passed_; }

 private:
  ToolSamples samples_;
  SurfaceTree surface_;
  Passage passage_;
  std::vector<char> passed_;
  std::vector<Crossing> crossings_;
  Pose before_;
  bool first_ = true;
};

/// A walk of tool and tissue: rest, creep, and jumps of both.
class Walk {
 public:
  explicit Walk(unsigned seed) : random_(seed) {}

  void step(State& state, const std::vector<Vec3>& rest_m) {
    const int kind = static_cast<int>(random_() % 8);
    const double tool_m = kind == 0 ? 0.02 : kind < 3 ? 0 : 0.001;
    const double tissue_m = kind == 1 ? 0.005 : kind % 2 == 0 ? 0 : 0.0003;
    for (ToolState& tool : state.tools) {
      tool.pose.position_m = 0.98 * tool.pose.position_m + test::randomIn(random_, tool_m);
      const Vec3 turn = test::randomIn(random_, 20 * tool_m);
      if (turn.norm() > 0)
        tool.pose.orientation =
            (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * tool.pose.orientation).normalized();
    }
    for (std::size_t i = 0; i < rest_m.size(); ++i) {
      if (tissue_m > 0)
        state.positions_m[i] += 0.1 * (rest_m[i] - state.positions_m[i]) + test::randomIn(random_, tissue_m);
    }
  }

 private:
  std::mt19937 random_;
};

TEST(Following, EveryStepIsAsMeasuredAnew) {
  const std::vector<TriangleMesh> bodies = {makeSphere(0.03, 2),
                                            test::moved(makeSphere(0.012, 1), test::at(0.03, 0.02, 0))};
  Scene scene = test::makeScene(bodies, {kBlade, Vec3(0.004, 0.06, 0.004)});
  scene.tools[1].box_size_m.reset();  // the same as a tool of triangles
  State state = test::restState(scene, {test::at(0, 0.045, 0), test::at(0.05, 0, 0)});
  const std::vector<Vec3> rest_m = state.positions_m;
  PenetrationMeter meter(scene, {kSpacing_m});
  std::vector<EagerPassages> eager;  // tool by tool, body by body
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t b = 0; b < 2; ++b) eager.emplace_back(scene, t, b);
  Walk walk(81);
  int deep = 0, apart = 0;
  for (int step = 0; step < 400; ++step) {
    const Penetration found = meter.measure(state);
    const Penetration anew = PenetrationMeter(scene, {kSpacing_m}).measure(state);
    ASSERT_EQ(found.depth_m, anew.depth_m) << step;
    ASSERT_EQ(found.inverted_triangles, anew.inverted_triangles) << step;
    if (std::isnan(anew.stand_off_m))
      ASSERT_TRUE(std::isnan(found.stand_off_m)) << step;
    else
      ASSERT_EQ(found.stand_off_m, anew.stand_off_m) << step;
    long long passed = 0;
    for (std::size_t t = 0; t < 2; ++t) {
      for (std::size_t b = 0; b < 2; ++b) {
        const SceneBody& body = scene.bodies[b];
        eager[2 * t + b].step(
            std::span(state.positions_m)
                .subspan(static_cast<std::size_t>(body.first_vertex), body.rest.vertices_m.size()),
            state.tools[t].pose);
      }
      const std::vector<char>&first = eager[2 * t].passed(), &second = eager[2 * t + 1].passed();
      for (std::size_t i = 0; i < first.size(); ++i) passed += (first[i] != 0 || second[i] != 0) ? 1 : 0;
    }
    ASSERT_EQ(found.passed_through, passed) << step;
    deep += anew.depth_m > 0.001;
    apart += anew.stand_off_m < 0.005;
    walk.step(state, rest_m);
  }
  EXPECT_GT(meter.measure(state).passed_through, 5);
  EXPECT_GT(deep, 50);
  EXPECT_GT(apart, 20);
}

// A plate 10 mm beside a small ball swings to its other side in one step, the straight way through it. Seen
// from the tool the ball has hardly moved.
TEST(Following, ATurnOfMoreThanARightAngleIsAStraightWayToo) {
  Scene scene = test::makeScene({makeSphere(0.002, 2)}, {Vec3(0.004, 0.004, 0.004)});
  scene.tools[0].box_size_m.reset();
  for (Vec3& vertex : scene.tools[0].surface.vertices_m) vertex.x() += 0.01;
  State state = test::restState(scene, {Pose()});
  PenetrationMeter meter(scene, {0.0005});
  EXPECT_EQ(meter.measure(state).passed_through, 0);
  state.tools[0].pose.orientation = Quat(Eigen::AngleAxisd(3.1, Vec3::UnitY()));
  EXPECT_GT(meter.measure(state).passed_through, 10);
}

// A blade that creeps towards a sphere and stops half a millimetre above it.
TEST(Following, WhatIsFarIsSearchedForRarelyAndWhatRestsNever) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
  PenetrationMeter meter(scene, {});
  State state = test::restState(scene, {test::at(0, 0.0515, 0)});
  const int steps = 200;
  for (int i = 0; i < steps; ++i) {
    meter.measure(state);
    state.tools[0].pose.position_m.y() -= 0.0001;
  }
  EXPECT_LT(static_cast<double>(meter.searches()), 0.1 * steps * static_cast<double>(meter.sampleCount()));
  meter.measure(state);
  const long long before = meter.searches();
  for (int i = 0; i < 100; ++i) meter.measure(state);
  EXPECT_LT(static_cast<double>(meter.searches() - before),
            0.005 * 100 * static_cast<double>(meter.sampleCount()))
      << "the nearest samples alone";
  EXPECT_NEAR(meter.measure(state).stand_off_m, 0.0005, 0.0001);
}

// Driven into it, and held there.
TEST(Following, HeldDeepInsideTheDeepestAloneIsSearchedFor) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
  PenetrationMeter meter(scene, {});
  State state = test::restState(scene, {test::at(0, 0.04, 0)});
  for (int i = 0; i < 200; ++i) {
    meter.measure(state);
    state.tools[0].pose.position_m.y() -= 0.0001;
  }
  EXPECT_LT(static_cast<double>(meter.searches()), 0.3 * 200 * static_cast<double>(meter.sampleCount()));
  meter.measure(state);
  const long long before = meter.searches();
  for (int i = 0; i < 100; ++i) meter.measure(state);
  EXPECT_LT(static_cast<double>(meter.searches() - before),
            0.005 * 100 * static_cast<double>(meter.sampleCount()))
      << "the deepest samples alone";
  EXPECT_GT(meter.measure(state).depth_m, 0.005);
}

// After a state that is not finite nothing of before counts.
TEST(Following, StartsAnewAfterAStateThatCannotBeMeasured) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
  PenetrationMeter meter(scene, {});
  const State outside = test::restState(scene, {test::at(0, 0.035, 0)});
  const State inside = test::restState(scene, {test::at(0, 0.02, 0)});
  State lost = outside;
  lost.positions_m[0].x() = std::nan("");
  meter.measure(outside);
  meter.measure(lost);
  EXPECT_EQ(meter.measure(inside).depth_m, PenetrationMeter(scene, {}).measure(inside).depth_m);
  meter.measure(lost);
  const Penetration found = meter.measure(outside), anew = PenetrationMeter(scene, {}).measure(outside);
  EXPECT_EQ(found.depth_m, 0);
  EXPECT_EQ(found.stand_off_m, anew.stand_off_m);
  EXPECT_EQ(found.passed_through, 0);
}

}  // namespace
}  // namespace fissure::following_test
