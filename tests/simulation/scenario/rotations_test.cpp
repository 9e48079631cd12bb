// Rotations as quaternions, and as an axis and an angle in degrees.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "scenario/key_tree.h"
#include "scenario/load.h"
#include "scenario_text.h"

namespace fissure::rotations_test {

namespace {

std::string withOrientation(const std::string& value) {
  std::string text(smallest_text);
  return text.insert(text.find("pipelines:"), "    orientation: " + value + "\n");
}

Eigen::Vector4d read(const std::string& value, const std::vector<Override>& overrides = {}) {
  return parseScenario(withOrientation(value), "a.yaml", overrides).scenario.bodies[0].orientation.coeffs();
}

std::string refusal(const std::string& value) {
  try {
    read(value);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Rotations, AnAxisAndAnAngleTurnCounterClockwise) {
  const double s = std::sin(std::numbers::pi / 12), c = std::cos(std::numbers::pi / 12);
  EXPECT_LE((read("{axis: [0, 1, 0], angle_deg: 30}") - Eigen::Vector4d(0, s, 0, c)).norm(), 1e-16);
  EXPECT_LE((read("{axis: [0, 0, 25], angle_deg: 30}") - Eigen::Vector4d(0, 0, s, c)).norm(), 1e-16);
  EXPECT_LE((read("{axis: [-1e300, 0, 0], angle_deg: 30}") - Eigen::Vector4d(-s, 0, 0, c)).norm(), 1e-16);
  EXPECT_EQ(read("{axis: [1, 2, 3], angle_deg: 0}"), Eigen::Vector4d(0, 0, 0, 1));
  EXPECT_EQ(read("{axis: [0, 1, 0], angle_deg: 180}"), Eigen::Vector4d(0, 1, 0, 0));
  EXPECT_EQ(read("{axis: [0, 1, 0], angle_deg: 720}"), Eigen::Vector4d(0, 0, 0, 1));
}

TEST(Rotations, AnAngleCanBeAnOverride) {
  EXPECT_EQ(read("{axis: [0, 1, 0], angle_deg: 30}", {{"bodies.ball.orientation.angle_deg", "180"}}),
            Eigen::Vector4d(0, 1, 0, 0));
}

TEST(Rotations, UnitQuaternionsKeepTheirBits) {
  EXPECT_EQ(read("[0.6, 0, 0, 0.8]"), Eigen::Vector4d(0.6, 0, 0, 0.8));
  const double half = std::sqrt(0.5);
  EXPECT_EQ(read("[0, 0.7071067811865476, 0, 0.7071067811865476]"), Eigen::Vector4d(0, half, 0, half));
}

TEST(Rotations, RoundedQuaternionsAreNormalised) {
  const Eigen::Vector4d rounded = read("[0, 0.707, 0, 0.707]");  // of length 0.99985
  EXPECT_DOUBLE_EQ(rounded.norm(), 1);
  EXPECT_DOUBLE_EQ(rounded.y(), std::sqrt(0.5));
  EXPECT_EQ(
      refusal("[0, 0.7, 0, 0.7]"),  // of length 0.98995
      "a.yaml:7: bodies.ball.orientation has length 0.9899494936611665, expected a unit quaternion [x, y, "
      "z, w] or {axis: [x, y, z], angle_deg: NUMBER}");
}

TEST(Rotations, WhatIsNeitherIsRefused) {
  const std::string expected =
      ", expected a unit quaternion [x, y, z, w] or {axis: [x, y, z], angle_deg: NUMBER}";
  const std::string path = "a.yaml:7: bodies.ball.orientation";
  EXPECT_EQ(refusal("30"), path + " is \"30\"" + expected);
  EXPECT_EQ(refusal("[0, 30, 0]"), path + " has 3 items" + expected);
  EXPECT_EQ(refusal("{axis: [0, 0, 0], angle_deg: 30}"), path + ".axis is zero, expected a direction");
  EXPECT_EQ(refusal("{axis: [0, 1, 0]}"),
            "a.yaml:7: missing key \"angle_deg\" in bodies.ball.orientation, expected it");
  EXPECT_EQ(refusal("{axis: [0, 1, 0], angle: 30}"),
            "a.yaml:7: unknown key \"angle\" in bodies.ball.orientation, did you mean \"angle_deg\"?");
  EXPECT_EQ(refusal("{axis: [0, 1, 0], angle_deg: .inf}"),
            path + ".angle_deg is \".inf\", expected a finite number");
}

// What was run is stored as quaternions, which read back to the same bits.
TEST(Rotations, AreResolvedToQuaternions) {
  const LoadedScenario loaded = parseScenario(withOrientation("{axis: [1, 2, 3], angle_deg: 77}"), "a.yaml");
  EXPECT_EQ(loaded.resolved.find("angle_deg"), std::string::npos);
  const LoadedScenario again = parseStoredScenario(loaded.resolved, "result.h5");
  EXPECT_EQ(again.scenario.bodies[0].orientation.coeffs(), loaded.scenario.bodies[0].orientation.coeffs());
}

TEST(Rotations, EveryRotationSaysBothForms) {
  std::size_t found = 0;
  const auto look = [&](const auto& self, const KeyNode& node) -> void {
    if (node.is_rotation) {
      ++found;
      EXPECT_NE(node.doc.find("angle_deg"), std::string::npos) << node.name;
    }
    for (const KeyNode& child : node.children) self(self, child);
  };
  look(look, scenarioKeys());
  EXPECT_GE(found, 6u);
}

}  // namespace
}  // namespace fissure::rotations_test
