// Bad input and usage: exit code 2, one line on stderr that says where, nothing on stdout, nothing simulated
// or left.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::bad_input_test {
namespace {

void expectRefused(const Outcome& outcome, const std::string& fragment) {
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_NE(outcome.err.find(fragment), std::string::npos) << outcome.err << "expected: " << fragment;
  EXPECT_EQ(outcome.out, "");
}

struct BadText {
  const char* name;
  const char* from;
  const char* to;
  const char* message;  ///< a part of it; a scenario's lines count from 1
};

void PrintTo(const BadText& bad, std::ostream* stream) {
  *stream << bad.name;
}

class BadScenario : public testing::TestWithParam<BadText> {};

TEST_P(BadScenario, IsRefusedWithItsLine) {
  const Folder folder;
  const BadText& bad = GetParam();
  folder.write("s.yaml", with(pressScenario(), bad.from, bad.to));
  expectRefused(runFissure(folder, {"run", "s.yaml"}), bad.message);
  expectRefused(runFissure(folder, {"validate", "s.yaml"}), bad.message);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.yaml"});
}

INSTANTIATE_TEST_SUITE_P(
    Texts, BadScenario,
    testing::Values(BadText{"unknown_key", "mass_kg: 0.1", "mas_kg: 0.1", "s.yaml:10: "},
                    BadText{"duplicate_key", "mass_kg: 0.1", "mass_kg: 0.1\n    mass_kg: 0.2", "s.yaml:11: "},
                    BadText{"wrong_type", "mass_kg: 0.1", "mass_kg: heavy", "s.yaml:10: "},
                    BadText{"list_for_number", "mass_kg: 0.1", "mass_kg: [0.1]", "s.yaml:10: "},
                    BadText{"octal", "subdivisions: 1", "subdivisions: 010", "s.yaml:8: "},
                    BadText{"negative_size", "0.04, 0.002", "0.04, -0.002", "s.yaml:15: "},
                    BadText{"nan", "radius_m: 0.03", "radius_m: .nan", "s.yaml:8: "},
                    BadText{"infinite", "radius_m: 0.03", "radius_m: .inf", "s.yaml:8: "},
                    BadText{"zero_duration", "duration_s: 0.03", "duration_s: 0", "s.yaml:4: "},
                    BadText{"step_above_duration", "step_s: 0.001", "step_s: 0.1", "s.yaml:4: "},
                    BadText{"unknown_pipeline", "pipeline: fukuhara", "pipeline: fukuhra", "fukuhara"},
                    BadText{"no_bodies", "bodies:", "bodies: []\ntools_off:", "s.yaml:"},
                    BadText{"future_format", "format: 1", "format: 2", "s.yaml:1: "},
                    BadText{"broken_yaml", "[0, 0.062, 0]", "[0, 0.062", "s.yaml:"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(BadRelation, FixedRegionsThatHoldNothingOrAll) {
  const Folder folder;
  const auto text = [](const std::string& fixed) {
    return with(pressScenario(), "    mass_kg: 0.1", "    fixed: " + fixed + "\n    mass_kg: 0.1");
  };
  folder.write("none.yaml", text("[{below_m: 0.001}, {below_m: -0.001}]"));
  expectRefused(runFissure(folder, {"run", "none.yaml"}), "bodies.sphere.fixed.1 holds no vertex");
  folder.write("all.yaml", text("[{below_m: 1}]"));
  expectRefused(runFissure(folder, {"validate", "all.yaml"}), "bodies.sphere.fixed holds every vertex");
  folder.write("both.yaml", text("[{below_m: 0, box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}}]"));
  expectRefused(runFissure(folder, {"run", "both.yaml"}), "both.yaml:10: bodies.sphere.fixed.0 expected");
  folder.write("key.yaml", text("[{box: {min_m: [0, 0, 0], max: [1, 1, 1]}}]"));
  expectRefused(runFissure(folder, {"run", "key.yaml"}), "key.yaml:10: unknown key \"max\"");
}

TEST(BadRelation, AGaugeThatHoldsNothing) {
  const Folder folder;
  folder.write("s.yaml", with(pressScenario(), "    mass_kg: 0.1",
                              "    gauges: [{name: far, box: {min_m: [1, 1, 1], max_m: [2, 2, 2]}}]\n"
                              "    mass_kg: 0.1"));
  for (const char* verb : {"run", "validate"})
    expectRefused(runFissure(folder, {verb, "s.yaml"}), "bodies.sphere.gauges.far holds no vertex");
}

TEST(BadRelation, RegionsOfAnElasticBody) {
  const Folder folder;
  const std::string of_shell =
      "    mass_kg: 0.1\n"
      "    material: {linear_stiffness: 0.5}\n"
      "    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}\n";
  const auto text = [&](const std::string& region) {
    return with(pressScenario("[{pipeline: swept}]"), of_shell,
                "    model: elastic\n    elastic: {regions: [{name: vessel, " + region + "}]}\n");
  };
  folder.write("none.yaml", text("box: {min_m: [1, 1, 1], max_m: [2, 2, 2]}"));
  for (const char* verb : {"run", "validate"})
    expectRefused(runFissure(folder, {verb, "none.yaml"}),
                  "bodies.sphere.elastic.regions.vessel holds no tetrahedron");
  folder.write("tag.yaml", text("tag: 2"));
  expectRefused(runFissure(folder, {"plan", "tag.yaml"}),
                "bodies.sphere.elastic.regions.vessel.tag: the tetrahedra of the body's shape have no tags");
  folder.write("where.yaml", text("youngs_modulus_Pa: 1000"));
  expectRefused(
      runFissure(folder, {"run", "where.yaml"}),
      "where.yaml:11: bodies.sphere.elastic.regions.vessel expected exactly one of tag, box and capsule");
  folder.write("ratio.yaml", text("poissons_ratio: 0.5, capsule: {from_m: [0, 0, 0], to_m: [0, 0, 0.01], "
                                  "radius_m: 0.01}"));
  expectRefused(runFissure(folder, {"run", "ratio.yaml"}),
                "ratio.yaml:11: bodies.sphere.elastic.regions.vessel.poissons_ratio is 0.5");
  folder.write("material.yaml", text("material: neo_hookean"));
  expectRefused(runFissure(folder, {"run", "material.yaml"}), "material.yaml:11: unknown key \"material\"");
}

TEST(BadRelation, FrictionWithoutAForce) {
  const Folder folder;
  folder.write("s.yaml", with(pressScenario("[{pipeline: raycast}]"), "nodes:", "friction: 0.3\n    nodes:"));
  expectRefused(runFissure(folder, {"run", "s.yaml"}), "s.yaml:16: tools.spatula.friction is 0.3");
}

TEST(BadFile, MissingScenario) {
  const Folder folder;
  expectRefused(runFissure(folder, {"run", "none.yaml"}), "none.yaml");
}

TEST(BadFile, EmptyScenario) {
  const Folder folder;
  folder.write("s.yaml", "");
  expectRefused(runFissure(folder, {"run", "s.yaml"}), "s.yaml");
}

TEST(BadFile, BinaryScenario) {
  const Folder folder;
  folder.write("s.yaml", std::string("\x7f\x45LF\0\0\xff\xfe\0garbage", 16));
  expectRefused(runFissure(folder, {"run", "s.yaml"}), "s.yaml");
}

TEST(BadFile, FolderAsScenario) {
  const Folder folder;
  expectRefused(runFissure(folder, {"run", "."}), ".");
}

TEST(BadFile, PipeAsScenario) {
  const Folder folder;
  ASSERT_EQ(runTool(folder, {"mkfifo", "s.yaml"}).code, 0);
  expectRefused(runFissure(folder, {"validate", "s.yaml"}), "no regular file");
}

TEST(BadFile, PipesAndDevicesAsOtherInputs) {
  const Folder folder;
  ASSERT_EQ(runTool(folder, {"mkfifo", "pipe"}).code, 0);
  for (const char* file : {"pipe", "/dev/zero"}) {
    for (const char* verb : {"fit", "info", "report", "export", "salvage"})
      expectRefused(runFissure(folder, {verb, file}), std::string(file) + ": is no regular file");
    expectRefused(runFissure(folder, {"render", file, "-o", "d"}),
                  std::string(file) + ": is no regular file");
    expectRefused(runFissure(folder, {"compare", file, file}), "is no regular file");
  }
  expectRefused(runFissure(folder, {"validate", "/proc/kmsg"}), "/proc/kmsg: has size 0");
}

TEST(BadFile, NamesTooLongForWhatIsMadeBesideTheResult) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  expectRefused(runFissure(folder, {"run", "s.yaml", "-o", std::string(241, 'a') + ".h5"}),
                "has a name of 244 bytes, expected at most ");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.yaml"});
}

TEST(BadFile, TooFewDescriptorsAreNoFullDisk) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizers need descriptors of their own";
#endif
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  const Outcome outcome = runTool(
      folder,
      {"sh", "-c", "exec 3>&- 4>&-; ulimit -n 5; exec " + fissureProgram() + " run s.yaml -o out.h5"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("Too many open files"), std::string::npos) << outcome.err;
}

TEST(BadFile, SurfaceWithAHole) {
  const Folder folder;
  folder.write("s.yaml",
               with(pressScenario(), "{type: sphere, radius_m: 0.03, subdivisions: 1}",
                    "{type: triangles, vertices_m: [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]], "
                    "faces: [[0, 2, 1], [0, 1, 3], [0, 3, 2]]}"));
  expectRefused(runFissure(folder, {"validate", "s.yaml"}), "bodies.sphere");
}

/// The press with its blade on a recorded path.
std::string replayScenario() {
  const std::string script = pressScenario();
  const std::size_t from = script.find("      type: script");
  const std::size_t to = script.find("pipelines:");
  return script.substr(0, from) +
         "      type: replay\n"
         "      file: hand.csv\n"
         "      rate_hz: 1000\n" +
         script.substr(to);
}

TEST(BadFile, LogThatLastsForAges) {
  const Folder folder;
  folder.write("s.yaml",
               with(with(replayScenario(), "rate_hz: 1000", "time_column: t"), ", duration_s: 0.03", ""));
  for (const std::string end : {"1e9", "1e18"}) {
    folder.write("hand.csv", "t,x,y,z\n0,0,0.062,0\n" + end + ",0,0.06,0\n");
    expectRefused(runFissure(folder, {"plan", "s.yaml"}), "1e8 steps");
  }
}

TEST(BadFile, EmptyNameForTheResult) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  expectRefused(runFissure(folder, {"run", "s.yaml", "-o", ""}), "-o");
}

TEST(BadFile, Logs) {
  const Folder folder;
  folder.write("s.yaml", replayScenario());
  expectRefused(runFissure(folder, {"run", "s.yaml"}), "hand.csv");
  folder.write("hand.csv", "x,y\n0,0.06\n0,0.05\n");
  expectRefused(runFissure(folder, {"run", "s.yaml"}), "z");
  folder.write("hand.csv", "");
  expectRefused(runFissure(folder, {"run", "s.yaml"}), "hand.csv");
  std::string log = "x,y,z\n";
  for (int i = 0; i < 50; ++i) log += "0,0.06" + std::to_string(99 - i) + ",0\n";
  folder.write("hand.csv", log);
  EXPECT_EQ(runFissure(folder, {"validate", "s.yaml"}).code, 0);
}

TEST(BadOutput, ExistingFileIsRefusedAndLeftAsItIs) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  folder.write("out.h5", std::string("not\0mine", 8));
  expectRefused(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}), "out.h5: exists already");
  EXPECT_EQ(folder.read("out.h5"), std::string("not\0mine", 8));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.h5", "s.yaml"}));
}

// A minute of work must not end with "cannot write": the scenario would run for hours.
TEST(BadOutput, UnwritablePlaceIsFoundBeforeSimulating) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario());
  folder.write("file", "");
  for (const char* output : {"/proc/out.h5", "file/out.h5", "/dev/null", ".", "no-name/"})
    expectRefused(runFissure(folder, {"run", "s.yaml", "-o", output, "--force"}), output);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"file", "s.yaml"}));
}

TEST(BadOutput, InputsAreNeverOverwritten) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  expectRefused(runFissure(folder, {"run", "s.yaml", "-o", "./s.yaml", "--force"}), "is an input");
  EXPECT_EQ(folder.read("s.yaml"), pressScenario());
}

TEST(BadUsage, CommandLines) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  folder.write("t.yaml", pressScenario());
  expectRefused(runFissure(folder, {}), "fissure: ");
  expectRefused(runFissure(folder, {"walk"}), "fissure: ");
  expectRefused(runFissure(folder, {"run"}), "SCENARIO");
  expectRefused(runFissure(folder, {"run", "s.yaml", "--fast"}), "--fast");
  expectRefused(runFissure(folder, {"run", "s.yaml", "-j", "0"}), "fissure run: --jobs");
  expectRefused(runFissure(folder, {"run", "s.yaml", "-j", "many"}), "fissure run: --jobs");
  expectRefused(runFissure(folder, {"run", "s.yaml", "--set", "nothing"}), "expected path=value");
  expectRefused(runFissure(folder, {"run", "s.yaml", "--set", "time.step=0.1"}), "step_s");
  expectRefused(runFissure(folder, {"run", "s.yaml", "--pipeline", "fukuhar"}), "did you mean \"fukuhara\"");
  expectRefused(runFissure(folder, {"run", "s.yaml", "t.yaml", "-o", "out.h5"}), "expected one scenario");
  expectRefused(runFissure(folder, {"run", "s.yaml", "t.yaml"}), "both would write out/press.h5");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"s.yaml", "t.yaml"}));
}

TEST(BadUsage, ValidateGoesOnAfterABadFile) {
  const Folder folder;
  folder.write("good.yaml", pressScenario());
  folder.write("bad.yaml", "format: 1\n");
  const Outcome outcome = runFissure(folder, {"validate", "bad.yaml", "good.yaml", "none.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "good.yaml: ok\n");
  EXPECT_NE(outcome.err.find("bad.yaml"), std::string::npos);
  EXPECT_NE(outcome.err.find("none.yaml"), std::string::npos);
}

TEST(BadResult, InfoRefusesWhatIsNoResult) {
  const Folder folder;
  folder.write("text.h5", "hello");
  expectRefused(runFissure(folder, {"info", "text.h5"}), "text.h5");
  expectRefused(runFissure(folder, {"info", "none.h5"}), "none.h5");
}

}  // namespace
}  // namespace fissure::programs::bad_input_test
