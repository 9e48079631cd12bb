#include "study/stability_cell.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace fissure {
namespace {

namespace fs = std::filesystem;

const fs::path kScene = fs::path(FISSURE_SOURCE_DIR) / "configs/studies/scenes/ball_shell.yaml";

StabilityAxis axis(const std::string& path, std::vector<std::string> multiplies = {}) {
  StabilityAxis made{path, std::move(multiplies), {}, {}, {}};
  made.logarithmic = AxisRange{1e-6, 1, 3};
  return made;
}

/// A cell of one axis of the study's shell: a ball of 30 mm radius under a blade 2 mm thick, at 0.1 m/s.
StabilityCell cellOf(const StabilityAxis& of, const std::string& value, double depth_share = 0.1) {
  const LoadedScenario base = loadScenario(kScene);
  StabilityMap map;
  map.name = "map";
  map.axes = {of};
  return StabilityCells(base, kScene, map, {100, 10, 0.4, depth_share}, "swept").cell({value});
}

Scenario scenarioOf(const StabilityCell& cell) {
  return loadScenario(kScene, cell.overrides).scenario;
}

const ScriptMotion& motionOf(const Scenario& scenario) {
  return std::get<ScriptMotion>(scenario.tools[0].motion);
}

TEST(StabilityCell, AFastToolGoesFromATenthOfItsDepthBeforeTheTissueToItsDepth) {
  const StabilityCell cell = cellOf(axis("time.step_s"), "0.01");  // 60 steps would go 60 mm
  const Scenario scenario = scenarioOf(cell);
  const ScriptMotion& motion = motionOf(scenario);
  EXPECT_NEAR(motion.start_m.y(), 0.03 + 0.001 + 0.0006, 1e-12);
  EXPECT_NEAR(motion.segments[0].move_to_m->y(), 0.031 - 0.006, 1e-12);
  EXPECT_EQ(cell.rest_from, 8u);  // 6.6 mm at 1 mm a step
  EXPECT_DOUBLE_EQ(*scenario.time.duration_s, 1);
  EXPECT_DOUBLE_EQ(scenario.time.settle_s, 0.1);
  EXPECT_NEAR(cell.thickness_m, 0.002, 1e-12);
}

TEST(StabilityCell, ASlowToolStillMeetsTheTissue) {
  const StabilityCell cell = cellOf(axis("time.step_s"), "1e-6");  // 60 steps go 6 um
  const ScriptMotion motion = motionOf(scenarioOf(cell));
  EXPECT_NEAR(motion.start_m.y() - 0.031, 1.5e-6, 1e-12);
  EXPECT_NEAR(motion.segments[0].move_to_m->y() - 0.031, -4.5e-6, 1e-12);
  EXPECT_NEAR(static_cast<double>(cell.rest_from), 61, 1);
}

TEST(StabilityCell, ASpeedOfTheMotionIsInTheMotionAlone) {
  const StabilityCell cell = cellOf(axis("tools.blade.motion.segments.0.speed_m_s"), "1e-6");
  for (const Override& change : cell.overrides)
    EXPECT_NE(change.path, "tools.blade.motion.segments.0.speed_m_s");
  EXPECT_EQ(motionOf(scenarioOf(cell)).segments[0].speed_m_s, 1e-6);
}

TEST(StabilityCell, AThinBladeStartsAtTheSameGap) {
  const StabilityCell cell = cellOf(axis("tools.blade.shape.size_m.1"), "1e-06");
  EXPECT_NEAR(motionOf(scenarioOf(cell)).start_m.y(), 0.03 + 0.5e-6 + 0.0006, 1e-12);
  EXPECT_NEAR(cell.thickness_m, 1e-6, 1e-15);
}

TEST(StabilityCell, AnAxisMultipliesNumbersAndLists) {
  const StabilityCell cell =
      cellOf(axis("length", {"bodies.ball.shape.radius_m", "tools.blade.shape.size_m"}), "1000");
  const Scenario scenario = scenarioOf(cell);
  EXPECT_DOUBLE_EQ(std::get<SphereShape>(scenario.bodies[0].shape).radius_m, 30);
  EXPECT_DOUBLE_EQ(std::get<BoxShape>(scenario.tools[0].shape).size_m.x(), 40);
  EXPECT_NEAR(motionOf(scenario).start_m.y(), 30 + 1 + 0.0015, 1e-9);  // a quarter of 6 mm
  EXPECT_THROW(cellOf(axis("x", {"name"}), "2"), InputError);
  EXPECT_THROW(cellOf(axis("x", {"bodies.cube.mass_kg"}), "2"), InputError);
}

TEST(StabilityCell, AStarStandsForThePipelineAndLawsAreSimulatedForThemselves) {
  EXPECT_EQ(cellOf(axis("pipelines.*.precision"), "f32").overrides.front().path, "pipelines.swept.precision");
  bool has_model = false;
  for (const Override& change : cellOf(axis("force.hc.k"), "7").overrides)
    has_model |= change.path == "force.hc.model" && change.value == "hunt_crossley";
  EXPECT_TRUE(has_model);
}

TEST(StabilityCell, AnAxisOverWholeNumbersIsKnown) {
  const LoadedScenario base = loadScenario(kScene);
  const auto isWhole = [&](const std::string& path, AxisRange range) {
    StabilityMap map;
    map.axes = {{path, {}, {}, range, {}}};
    return StabilityCells(base, kScene, map, {100, 10, 0.4, 0.1}, "swept").lastAxisIsWhole();
  };
  EXPECT_TRUE(isWhole("bodies.ball.shape.subdivisions", {0, 4, 3}));
  EXPECT_TRUE(isWhole("tools.blade.nodes.resolution.0", {2, 32, 2}));
  EXPECT_TRUE(isWhole("bodies.ball.solver.position_iterations", {100, 500, 5}));
  EXPECT_TRUE(isWhole("bodies.ball.solver.position_iterations", {500, 100, 5}));
  EXPECT_FALSE(isWhole("bodies.ball.mass_kg", {1, 3, 3}));
  EXPECT_FALSE(isWhole("bodies.ball.mass_kg", {100, 500, 5}));
  EXPECT_FALSE(isWhole("world.gravity_m_s2.1", {-981, 0, 4}));
}

// Every step has a row and is measured, whatever the scenario says: classes are those of all steps.
TEST(StabilityCell, EveryStepIsARow) {
  const LoadedScenario base =
      loadScenario(kScene, {{"record", "{every: 10, snapshots_every_s: 0.1}"}, {"measure.every", "5"}});
  StabilityMap map;
  map.axes = {axis("bodies.ball.mass_kg")};
  const StabilityCell cell = StabilityCells(base, kScene, map, {100, 10, 0.4, 0.1}, "swept").cell({"1"});
  const Scenario scenario = parseScenario(base.composed, kScene, cell.overrides).scenario;
  EXPECT_EQ(stepsPerRow(scenario.record, scenario.measure), 1);
  EXPECT_EQ(stepsPerMeasurement(scenario.measure), 1);
  EXPECT_FALSE(scenario.record.snapshots_every_s);
}

TEST(StabilityCell, WhatTheChecksRefuseIsACellWithAReason) {
  const fs::path scene = kScene.parent_path() / "ball_elastic.yaml";
  const LoadedScenario base = loadScenario(scene);
  StabilityMap map;
  map.name = "map";
  map.axes = {axis("bodies.ball.elastic.youngs_modulus_Pa"), axis("time.step_s")};
  const StabilityCells cells(base, scene, map, {100, 0, 0.4, 0.1}, "swept");
  EXPECT_EQ(cells.cell({"1e4", "0.001"}).refused, "");
  EXPECT_NE(cells.cell({"1e9", "0.1"}).refused.find("more than 10000 substeps"), std::string::npos);
}

TEST(StabilityCell, CellsThatAreNotValidAreNamed) {
  for (const auto& [path, value] :
       std::vector<std::pair<std::string, std::string>>{{"time.step_s", "-1"},
                                                        {"time.step_s", "fast"},
                                                        {"bodies.ball.mass_kg", "0"},
                                                        {"bodies.ball.weight_kg", "1"}}) {
    try {
      cellOf(axis(path), value);
      ADD_FAILURE() << path << "=" << value;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(value), std::string::npos) << error.what();
    }
  }
}

/// The message about a study file with this text.
std::string refusal(const std::string& text) {
  const fs::path file = fs::path(testing::TempDir()) / "fissure_study_refused.yaml";
  std::ofstream(file) << text;
  try {
    loadStability(file);
  } catch (const InputError& error) {
    return error.text();
  }
  return "none";
}

TEST(StabilityFile, RefusesWhatCannotBeMeant) {
  const std::string head = "format: 1\nname: s\n";
  const auto maps = [&](const std::string& axes, const std::string& base = "base: b.yaml\n") {
    return head + base + "maps: [{name: m, axes: [" + axes + "]}]\n";
  };
  EXPECT_EQ(refusal(maps("{path: a, values: [1, 2]}")), "none");
  EXPECT_NE(refusal(""), "none");
  EXPECT_NE(refusal("# nothing\n").find("empty"), std::string::npos);
  EXPECT_NE(refusal("bodies: []\n").find("a scenario"), std::string::npos);
  EXPECT_NE(refusal("axes: []\n").find("a sweep"), std::string::npos);
  EXPECT_NE(refusal(head).find("maps"), std::string::npos);
  EXPECT_NE(refusal(maps("{path: a, values: [1]}", "")).find("no base"), std::string::npos);
  EXPECT_NE(refusal(maps("{path: a}")).find("none of values"), std::string::npos);
  EXPECT_NE(refusal(maps("{path: a, values: [1], linear: {from: 0, to: 1, count: 2}}")).find("several"),
            std::string::npos);
  EXPECT_NE(refusal(maps("{path: a, values: [1, 1.0]}")).find("twice"), std::string::npos);
  EXPECT_NE(refusal(maps("{path: a, multiplies: [b], values: [x]}")).find("multiplies"), std::string::npos);
  EXPECT_NE(refusal(maps("{path: a, logarithmic: {from: 0, to: 1, count: 2}}")).find("above 0"),
            std::string::npos);
  EXPECT_NE(refusal(maps("{path: a, values: [1]}, {path: a, values: [1]}")).find("second axis"),
            std::string::npos);
  EXPECT_NE(refusal(maps("{path: a, value: [1]}")).find("value"), std::string::npos);
}

TEST(StabilityFile, ValuesOfRangesAreRound) {
  StabilityAxis of{"a", {}, {}, {}, AxisRange{1e-6, 0.1, 6}};
  EXPECT_EQ(axisValues(of), (std::vector<std::string>{"1e-06", "1e-05", "1e-04", "0.001", "0.01", "0.1"}));
  of.logarithmic.reset();
  of.linear = AxisRange{-1, 1, 3};
  EXPECT_EQ(axisValues(of), (std::vector<std::string>{"-1", "0", "1"}));
}

}  // namespace
}  // namespace fissure
