// explain, schema, init and plan --resolved from outside.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"
#include "store/result_file.h"

namespace fissure::programs::keys_test {
namespace {

TEST(Explain, SaysWhatAKeyMeans) {
  const Folder folder;
  const Outcome one = runFissure(folder, {"explain", "bodies.elastic.youngs_modulus_Pa"});
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_NE(one.out.find("Young's modulus"), std::string::npos);
  const Outcome top = runFissure(folder, {"explain"});
  EXPECT_EQ(top.code, 0);
  for (const char* key : {"\n    bodies ", "\n    sweep.axes ", "\n    tolerances.tolerances "})
    EXPECT_NE(top.out.find(key), std::string::npos) << top.out;
  const Outcome all = runFissure(folder, {"explain", "--all"});
  EXPECT_NE(all.out.find("\ntools.shape.box.size_m\n"), std::string::npos);
  const Outcome unknown = runFissure(folder, {"explain", "yongs_modulus"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.out, "");
  EXPECT_EQ(unknown.err, "\"yongs_modulus\" is no key, did you mean \"youngs_modulus_Pa\"?\n");
}

TEST(Explain, HelpOfTheVerbsEndsWithAnExample) {
  const Folder folder;
  for (const char* verb : {"explain", "schema", "init", "plan"}) {
    const Outcome help = runFissure(folder, {verb, "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find("Example: fissure " + std::string(verb)), std::string::npos) << help.out;
  }
}

TEST(Schema, UnknownKindsAreRefused) {
  const Folder folder;
  EXPECT_EQ(runFissure(folder, {"schema", "sweep"}).code, 0);
  EXPECT_EQ(runFissure(folder, {"schema", "swep"}).code, 2);
}

/// The scenario's, as the result has it.
std::string hashOf(const std::filesystem::path& result) {
  for (const auto& [name, value] : readResultInfo(result).provenance)
    if (name == "scenario_hash") return value;
  return "";
}

TEST(PlanResolved, RunsAgainAndGivesTheSame) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  const Outcome resolved = runFissure(folder, {"plan", "s.yaml", "--resolved"});
  ASSERT_EQ(resolved.code, 0) << resolved.err;
  EXPECT_NE(resolved.out.find("gravity_m_s2: [0, -9.81, 0]"), std::string::npos) << resolved.out;
  folder.write("r.yaml", resolved.out);
  EXPECT_EQ(runFissure(folder, {"plan", "r.yaml", "--resolved"}).out, resolved.out);
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "s.h5"}).code, 0);
  ASSERT_EQ(runFissure(folder, {"run", "r.yaml", "-o", "r.h5"}).code, 0);
  EXPECT_NE(hashOf(folder / "s.h5"), "");
  EXPECT_EQ(hashOf(folder / "s.h5"), hashOf(folder / "r.h5"));
  const Outcome same = runFissure(folder, {"compare", "s.h5", "r.h5", "--exact"});
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_EQ(runFissure(folder, {"plan", "s.yaml", "r.yaml", "--resolved"}).code, 2);
}

TEST(Init, WritesScenariosThatAreGood) {
  const Folder folder;
  for (const std::string kind : {"press", "clamp", "fissure", "replay", "organ", "elastic"}) {
    const Outcome made = runFissure(folder, {"init", "my_" + kind, "--template", kind});
    ASSERT_EQ(made.code, 0) << made.err;
    const Outcome good = runFissure(folder, {"validate", "my_" + kind + ".yaml"});
    EXPECT_EQ(good.code, 0) << kind << good.err;
    EXPECT_EQ(good.out, "my_" + kind + ".yaml: ok\n") << "nothing is odd about a template";
    EXPECT_NE(folder.read("my_" + kind + ".yaml").find("\nname: my_" + kind + "\n"), std::string::npos);
  }
  EXPECT_EQ(runFissure(folder, {"init", "plain"}).out, "plain.yaml\n");
  const Outcome replay = runFissure(folder, {"init", "hand", "--template", "replay"});
  EXPECT_EQ(replay.out, "hand.yaml\nhand.csv\n");
}

TEST(Init, WritesASweepThatIsGood) {
  const Folder folder;
  EXPECT_EQ(runFissure(folder, {"init", "blades", "--template", "sweep"}).out,
            "blades.yaml\nblades_scene.yaml\n");
  const Outcome planned = runFissure(folder, {"sweep", "blades.yaml", "--dry-run"});
  EXPECT_EQ(planned.code, 0) << planned.err;
}

TEST(Init, WhatItWritesRuns) {
  const Folder folder;
  ASSERT_EQ(runFissure(folder, {"init", "organ_1", "--template", "organ"}).code, 0);
  const Outcome run = runFissure(folder, {"run", "organ_1.yaml", "--pipeline", "swept"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("held, proved"), std::string::npos) << run.out;
}

TEST(Init, RefusesToOverwriteAndBadNames) {
  const Folder folder;
  folder.write("a.csv", "mine\n");
  const Outcome taken = runFissure(folder, {"init", "a", "--template", "replay"});
  EXPECT_EQ(taken.code, 2);
  EXPECT_EQ(taken.err, "a.csv: exists already, expected a new name\n");
  EXPECT_EQ(folder.read("a.csv"), "mine\n");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.csv"}) << "nothing is written in part";
  for (const char* name : {"../a", "a b", ""}) EXPECT_EQ(runFissure(folder, {"init", name}).code, 2) << name;
  EXPECT_EQ(runFissure(folder, {"init", "b", "--template", "prss"}).code, 2);
}

}  // namespace
}  // namespace fissure::programs::keys_test
