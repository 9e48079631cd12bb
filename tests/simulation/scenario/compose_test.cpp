#include <string>

#include "scenario_text.h"

namespace fissure::compose_test {

namespace {

const std::string base_text =
    "format: 1\n"
    "name: below\n"
    "time: {step_s: 0.002, duration_s: 1}\n"
    "ground: {height_m: 0.5}\n"
    "bodies:\n"
    "  - {name: ball, shape: {type: sphere, radius_m: 0.03, subdivisions: 3}, mass_kg: 0.2}\n"
    "pipelines:\n"
    "  - {pipeline: default, settings: tuned}\n"
    "  - {name: full, pipeline: fukuhara, sweeps: 5}\n"
    "force:\n"
    "  - {name: hc, model: hunt_crossley, k: 300}\n";

class Base : public ScenarioFiles {
 protected:
  Base() { write("base.yaml", base_text); }
  Scenario load(const std::string& text) const { return loadScenario(write("top.yaml", text)).scenario; }
};

TEST_F(Base, MapsMergeKeyByKey) {
  const Scenario s =
      load("base: base.yaml\nname: above\ntime: {duration_s: 2}\nworld: {air_density_kg_m3: 0}\n");
  EXPECT_EQ(s.name, "above");
  EXPECT_EQ(s.time.step_s, 0.002);
  EXPECT_EQ(s.time.duration_s, 2);
  EXPECT_EQ(s.world.air_density_kg_m3, 0);
  EXPECT_EQ(s.ground.value().height_m, 0.5);
}

TEST_F(Base, ListsOfNamedItemsMergeByName) {
  const Scenario s = load(
      "base: base.yaml\n"
      "bodies: [{name: cube, shape: {type: box, size_m: [1, 1, 1]}}, {name: ball, mass_kg: 0.3}]\n"
      "pipelines: [{pipeline: default, sdf_voxel_m: 0.01}]\n");
  ASSERT_EQ(s.bodies.size(), 2u);
  EXPECT_EQ(s.bodies[0].name, "ball");
  EXPECT_EQ(s.bodies[0].mass_kg, 0.3);
  EXPECT_EQ(std::get<SphereShape>(s.bodies[0].shape).subdivisions, 3);
  EXPECT_EQ(s.bodies[1].name, "cube");
  // A pipeline without a name is called after its pipeline.
  ASSERT_EQ(s.pipelines.size(), 2u);
  EXPECT_EQ(s.pipelines[0].settings, SettingsPreset::tuned);
  EXPECT_EQ(s.pipelines[0].sdf_voxel_m, 0.01);
}

TEST_F(Base, OtherListsAndEmptyListsReplace) {
  const Scenario s = load("base: base.yaml\nworld: {gravity_m_s2: [0, 0, 1]}\nforce: []\n");
  EXPECT_EQ(s.world.gravity_m_s2, Vec3(0, 0, 1));
  EXPECT_TRUE(s.force.empty());
}

TEST_F(Base, AMapOfAnotherTypeReplaces) {
  const Scenario s = load("base: base.yaml\nbodies: [{name: ball, shape: {type: box, size_m: [1, 2, 3]}}]\n");
  EXPECT_EQ(std::get<BoxShape>(s.bodies[0].shape).size_m, Vec3(1, 2, 3));
  EXPECT_EQ(s.bodies[0].mass_kg, 0.2);
}

TEST_F(Base, IsRelativeToItsFileAndNestsAndIsAnInput) {
  write("sub/middle.yaml", "base: ../base.yaml\nname: middle\n");
  const std::filesystem::path top = write("top.yaml", "base: sub/middle.yaml\ntime: {step_s: 0.005}\n");
  const LoadedScenario loaded = loadScenario(top);
  EXPECT_EQ(loaded.scenario.name, "middle");
  EXPECT_EQ(loaded.scenario.time.step_s, 0.005);
  EXPECT_EQ(loaded.scenario.time.duration_s, 1);
  EXPECT_EQ(loaded.scenario.directory, folder_);
  EXPECT_EQ(loaded.source, "base: sub/middle.yaml\ntime: {step_s: 0.005}\n");
  ASSERT_EQ(loaded.inputs.size(), 3u);
  EXPECT_EQ(loaded.inputs[0], top);
  EXPECT_EQ(loaded.inputs[1], folder_ / "sub/middle.yaml");
  EXPECT_TRUE(std::filesystem::equivalent(loaded.inputs[2], folder_ / "base.yaml"));
  // The resolved text stands alone: no base is needed.
  EXPECT_EQ(parseScenario(loaded.resolved, top).scenario, loaded.scenario);
  EXPECT_EQ(loaded.resolved.find("base"), std::string::npos);
}

TEST_F(Base, ErrorsSayTheFileThatIsWrong) {
  write("bad.yaml", "format: 1\nname: x\ntiem: {}\n");
  write("top.yaml", "base: bad.yaml\n");
  EXPECT_EQ(loadError("top.yaml"), "bad.yaml:3: unknown key \"tiem\", did you mean \"time\"?");
  write("top.yaml", "base: base.yaml\nname: above\ntime: {step_s: -1}\n");
  EXPECT_EQ(loadError("top.yaml"), "top.yaml:3: time.step_s is -1, expected a number above 0");
  // The value of the base, made wrong by the file above it: said where the wrong value stands.
  write("top.yaml", "base: base.yaml\ntime: {duration_s: 1e-3}\n");
  EXPECT_EQ(loadError("top.yaml"),
            "base.yaml:3: time.step_s is 0.002, expected at most the duration, 0.001 s");
}

TEST_F(Base, CyclesAreErrors) {
  write("a.yaml", "name: a\nbase: b.yaml\n");
  write("b.yaml", "base: sub/../a.yaml\n");
  std::filesystem::create_directories(folder_ / "sub");
  EXPECT_EQ(loadError("a.yaml"),
            "b.yaml:1: base sub/../a.yaml leads back to itself, expected no cycle of bases");
  write("self.yaml", "base: self.yaml\n");
  EXPECT_EQ(loadError("self.yaml"),
            "self.yaml:1: base self.yaml leads back to itself, expected no cycle of bases");
}

TEST_F(Base, MissingOrWrongBase) {
  write("top.yaml", "name: x\nbase: none.yaml\n");
  EXPECT_EQ(loadError("top.yaml"), "top.yaml:2: base none.yaml: no such file, expected a scenario file");
  write("top.yaml", "name: x\nbase: .\n");
  EXPECT_EQ(loadError("top.yaml"), "top.yaml:2: base .: is a folder, expected a scenario file");
  write("top.yaml", "name: x\nbase: [base.yaml]\n");
  EXPECT_EQ(loadError("top.yaml"), "top.yaml:2: base is no file name, expected one");
  write("top.yaml", "name: x\nbase:\n");
  EXPECT_EQ(loadError("top.yaml"), "top.yaml:2: base is no file name, expected one");
}

TEST_F(Base, MergingDoesNotHideADuplicateName) {
  write("top.yaml", "base: base.yaml\nbodies:\n  - {name: ball, mass_kg: 1}\n  - {name: ball, mass_kg: 2}\n");
  EXPECT_EQ(loadError("top.yaml"), "top.yaml:4: duplicate name \"ball\", expected each name once");
}

TEST_F(Base, LogsStartFromTheFolderOfTheFileThatNamesThem) {
  write("logs/hand.csv", "x,y,z\n0,0,0\n");
  write("logs/replay.yaml",
        "base: ../base.yaml\n"
        "tools: [{name: blade, shape: {type: box, size_m: [1, 1, 1]},"
        " motion: {type: replay, file: hand.csv, rate_hz: 1000}}]\n");
  const std::filesystem::path top = write("top.yaml", "base: logs/replay.yaml\n");
  const LoadedScenario loaded = loadScenario(top);
  EXPECT_EQ(std::get<ReplayMotion>(loaded.scenario.tools[0].motion).file, "logs/hand.csv");
  EXPECT_EQ(loaded.inputs.back(), folder_ / "logs/hand.csv");
  EXPECT_EQ(parseScenario(loaded.resolved, top).scenario, loaded.scenario);
}

class SetValue : public testing::Test {
 protected:
  static Scenario with(const std::string& path, const std::string& value) {
    return parseScenario(base_text, "a.yaml", {{path, value}}).scenario;
  }
  static std::string error(const std::string& path, const std::string& value) {
    return inputError([&] { with(path, value); });
  }
};

TEST_F(SetValue, ReplacesValuesByKeysNamesAndIndices) {
  EXPECT_EQ(with("time.step_s", "0.004").time.step_s, 0.004);
  EXPECT_EQ(with("bodies.ball.mass_kg", "7").bodies[0].mass_kg, 7);
  EXPECT_EQ(with("bodies.0.mass_kg", "7").bodies[0].mass_kg, 7);
  EXPECT_EQ(with("pipelines.full.sweeps", "20").pipelines[1].sweeps, 20);
  EXPECT_EQ(with("pipelines.default.settings", "stock").pipelines[0].settings, SettingsPreset::stock);
  EXPECT_EQ(with("force.hc.lambda", "1").force[0].coefficients.lambda, 1);
}

TEST_F(SetValue, TakesAnyYamlAndReplacesTheWholeValue) {
  const Scenario box = with("bodies.ball.shape", "{type: box, size_m: [1, 2, 3]}");
  EXPECT_EQ(std::get<BoxShape>(box.bodies[0].shape).size_m, Vec3(1, 2, 3));
  EXPECT_EQ(with("bodies.ball.shape", "{type: sphere, radius_m: 1}").bodies[0].shape,
            (decltype(BodySettings::shape)(SphereShape{1.0, 2})));
  EXPECT_TRUE(with("force", "[]").force.empty());
}

TEST_F(SetValue, SetsWhatTheFileLeftOut) {
  EXPECT_EQ(with("record.frames.size_px", "[320, 240]").record.frames.value().width_px, 320);
  EXPECT_EQ(with("bodies.ball.solver.damping", "0.5").bodies[0].solver.damping, 0.5);
  EXPECT_EQ(with("world.gravity_m_s2", "[0, 0, 0]").world.gravity_m_s2, Vec3(0, 0, 0));
}

TEST_F(SetValue, ItemsOfPlainListsHaveIndices) {
  const std::string text = base_text + "world: {gravity_m_s2: [0, -9.81, 0]}\n";
  const Scenario s = parseScenario(text, "a.yaml", {{"world.gravity_m_s2.1", "-1.62"}}).scenario;
  EXPECT_EQ(s.world.gravity_m_s2, Vec3(0, -1.62, 0));
}

TEST_F(SetValue, LaterOverridesSeeEarlierOnes) {
  const Scenario s = parseScenario(base_text, "a.yaml",
                                   {{"force", "[{model: linear_elastic}]"}, {"force.linear_elastic.k", "9"}})
                         .scenario;
  EXPECT_EQ(s.force.at(0).coefficients.k, 9);
}

TEST_F(SetValue, ErrorsNameTheOverride) {
  EXPECT_EQ(error("time.stepp_s", "1"),
            "--set time.stepp_s: unknown key \"stepp_s\" in time, did you mean \"step_s\"?");
  EXPECT_EQ(error("tiem.step_s", "1"), "--set tiem.step_s: unknown key \"tiem\", did you mean \"time\"?");
  EXPECT_EQ(error("bodies.bal.mass_kg", "1"),
            "--set bodies.bal.mass_kg: bodies has no item \"bal\", did you mean \"ball\"?");
  EXPECT_EQ(error("bodies.7.mass_kg", "1"),
            "--set bodies.7.mass_kg: bodies has no item \"7\", expected one of ball");
  EXPECT_EQ(error("time.step_s.x", "1"),
            "--set time.step_s.x: time.step_s is a single value, expected it to have an entry \"x\"");
  EXPECT_EQ(error("time..x", "1"), "--set time..x: an empty name in the path, expected key.key=value");
  EXPECT_EQ(error("", "1"), "--set : an empty name in the path, expected key.key=value");
  EXPECT_EQ(error("base", "b.yaml").find("--set base: unknown key \"base\""), 0u);
}

TEST_F(SetValue, ErrorsInValuesNameTheOverrideAndNoLine) {
  EXPECT_EQ(error("time.step_s", "fast"), "--set time.step_s: time.step_s is \"fast\", expected a number");
  EXPECT_EQ(error("time.step_s", "-1"), "--set time.step_s: time.step_s is -1, expected a number above 0");
  EXPECT_EQ(error("time.step_s", ""), "--set time.step_s: time.step_s is empty, expected a number");
  EXPECT_EQ(error("pipelines.default.pipeline", "null")
                .find("--set pipelines.default.pipeline: pipelines.0.pipeline is "),
            0u);
  EXPECT_EQ(error("time", "{step_s: 1, step_s: 2}").find("--set time: duplicate key \"step_s\", "), 0u);
  EXPECT_EQ(error("time", "{step_s: 1").find("--set time: "), 0u);
  EXPECT_EQ(error("time", "{stepp_s: 1}"),
            "--set time: unknown key \"stepp_s\" in time, did you mean \"step_s\"?");
}

}  // namespace

}  // namespace fissure::compose_test
