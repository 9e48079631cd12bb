#include "measure/soundness.h"

#include <gtest/gtest.h>

#include "measure/probes.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::soundness_test {

namespace {

/// Two spheres of 128 triangles, no tool.
class SoundnessTest : public ::testing::Test {
 protected:
  SoundnessTest()
      : scene_(test::makeScene({makeSphere(0.03, 2), makeSphere(0.03, 2)}, {})),
        state_(test::restState(scene_, {})),
        soundness_(scene_) {
    scene_.bodies[1].name = "vessel";
    soundness_ = Soundness(scene_);
  }
  void add(const Soundness::BodyStep& vessel) {
    soundness_.add(state_, {{}, vessel});
    ++state_.step;
  }
  SummaryValue scalar(const std::string& name) const {
    Summary summary;
    soundness_.summarize(summary);
    for (const SummaryValue& value : summary)
      if (value.name == name) return value;
    return {name, std::string("absent")};
  }
  std::string text(const std::string& name) const { return std::get<std::string>(scalar(name).value); }
  long long count(const std::string& name) const { return std::get<long long>(scalar(name).value); }

  Scene scene_;
  State state_;
  Soundness soundness_;
};

TEST_F(SoundnessTest, SoundTissueHasNoFirstStep) {
  add({});
  EXPECT_EQ(count("unsound_steps"), 0);
  EXPECT_EQ(text("first_unsound_step"), "absent");
}

TEST_F(SoundnessTest, InversionBeforeAnyContactIsTheTissuesOwn) {
  add({});
  add({.inverted = 1});
  add({.inverted = 2});
  EXPECT_EQ(count("unsound_steps"), 2);
  EXPECT_EQ(count("first_unsound_step"), 1);
  EXPECT_EQ(text("unsound_tissue"), "vessel has 1 of 128 triangles inverted before any tool touched it");
}

TEST_F(SoundnessTest, InversionByAToolIsNot) {
  add({.inverted = 100, .touched = true, .touched_before = true});
  add({.inverted = 60, .touched_before = true});
  EXPECT_EQ(count("unsound_steps"), 0);
}

TEST_F(SoundnessTest, WhatStaysInsideOutWithoutAToolIsUnsound) {
  add({.inverted = 111, .touched = true, .touched_before = true});
  add({.inverted = 111, .touched_before = true});
  EXPECT_EQ(count("first_unsound_step"), 1);
  EXPECT_EQ(text("unsound_tissue"), "vessel is inside out: 87 % of its triangles, while no tool touches it");
}

TEST_F(SoundnessTest, ThreeTimesAsLongHasExploded) {
  const std::size_t first = static_cast<std::size_t>(scene_.bodies[1].first_vertex);
  const auto stretch = [&](double factor) {
    for (std::size_t v = first; v < state_.positions_m.size(); ++v)
      state_.positions_m[v].x() = factor * scene_.bodies[1].rest.vertices_m[v - first].x();
  };
  stretch(2.9);
  add({.touched = true, .touched_before = true});
  EXPECT_EQ(count("unsound_steps"), 0);
  stretch(3.1);
  add({.touched = true, .touched_before = true});
  EXPECT_EQ(text("unsound_tissue"), "vessel explodes: 0.186 m long, 0.06 m at rest");
}

// Through the probes of a scene without tools.
TEST(SoundnessProbe, LooksAtTissueWithoutTools) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {});
  State state = test::restState(scene, {});
  auto probes = makeProbes(Scenario(), scene);
  RecordLayout layout = declareLayout(probes);
  RecordRow row(layout.columns());
  const auto step = [&] {
    for (const auto& probe : probes) probe->sample(state, row);
    ++state.step;
  };
  step();
  for (Vec3& position_m : state.positions_m) position_m.x() = -position_m.x();
  step();
  Summary summary;
  for (const auto& probe : probes) probe->summarize(summary);
  const auto found = std::find_if(summary.begin(), summary.end(), [](const SummaryValue& value) {
    return value.name == "first_unsound_step";
  });
  ASSERT_NE(found, summary.end());
  EXPECT_EQ(std::get<long long>(found->value), 1);
}

}  // namespace
}  // namespace fissure::soundness_test
