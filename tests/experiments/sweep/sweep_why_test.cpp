#include "sweep/sweep_why.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/write_file.h"
#include "sweep_text.h"

namespace fissure::sweep_why_test {

namespace {

namespace fs = std::filesystem;

const std::string scenario =
    "{format: 1, name: press, bodies: [{name: ball, shape: {type: sphere, radius_m: 0.03, subdivisions: 1}, "
    "mass_kg: 0.1}], time: {duration_s: 1}, force: [{name: hc, model: hunt_crossley, k: 200, lambda: 0, n: "
    "1.5}], pipelines: [{pipeline: default}]}";

SweepManifest manifestOf(const std::string& axes) {
  SweepManifest manifest;
  manifest.settings = sweepOf(axes);
  manifest.scenario = scenario;
  manifest.inputs = {{"ball.obj", "fnv1a64:7"}};
  manifest.engines = {{"f64", "fnv1a64:1"}};
  manifest.pipelines = {"default"};
  manifest.points = SweepPoints(manifest.settings);
  return manifest;
}

const std::string two_masses = "axes: [{path: bodies.ball.mass_kg, values: [0.1, 0.2]}]\n";

/// A folder in which `planned` was planned, and what is said of `now`.
class WhyTest : public testing::Test {
 protected:
  WhyTest() : folder_(fs::path(testing::TempDir()) / ("fissure_why_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~WhyTest() override { fs::remove_all(folder_); }

  void plan(const SweepManifest& manifest) const { writeFile(manifestFile(folder_), manifestText(manifest)); }
  void record(const SweepManifest& manifest, std::size_t task, RunEnd end,
              const std::string& file = "") const {
    TaskRecord record;
    record.task = SweepPlan(manifest, folder_).tasks().at(task).id;
    record.status = {end, end == RunEnd::ok ? "" : "signal 9"};
    record.numbers = encodeNumbers({{"depth_m"}, 1, {1}, {}, {}});
    record.file = file;
    JournalWriter(journalFolder(folder_)).append(encodeRecord(record));
  }
  std::vector<TaskReason> reasons(const SweepManifest& manifest, std::size_t shard = 0,
                                  std::size_t shards = 1, std::optional<std::size_t> lost = {}) const {
    const SweepPlan plan(manifest, folder_);
    SweepState state(plan, folder_);
    if (lost) state.forget(*lost);
    return whyTasksRun(state, folder_, shard, shards);
  }
  std::vector<std::string> texts(const SweepManifest& manifest) const {
    std::vector<std::string> said;
    for (const TaskReason& reason : reasons(manifest)) said.push_back(reason.text);
    return said;
  }

  fs::path folder_;
};

using Texts = std::vector<std::string>;

TEST_F(WhyTest, WhatHasNoRecordRunsAndWhatFinishedDoesNot) {
  const SweepManifest manifest = manifestOf(two_masses);
  EXPECT_EQ(texts(manifest), (Texts{"no record of it", "no record of it"}));  // and no plan
  plan(manifest);
  record(manifest, 0, RunEnd::ok);
  EXPECT_EQ(texts(manifest), (Texts{"finished: ok", "no record of it"}));
  EXPECT_FALSE(reasons(manifest)[0].runs());
  EXPECT_TRUE(reasons(manifest)[1].runs());
  record(manifest, 1, RunEnd::non_finite);
  EXPECT_EQ(texts(manifest)[1], "finished: non_finite (signal 9)");
}

TEST_F(WhyTest, WhatFailedIsTriedAgain) {
  const SweepManifest manifest = manifestOf(two_masses);
  plan(manifest);
  record(manifest, 1, RunEnd::crashed);
  EXPECT_EQ(texts(manifest), (Texts{"no record of it", "tried again: crashed (signal 9)"}));
  EXPECT_EQ(nameOf(reasons(manifest)[1].why), "failed");
}

TEST_F(WhyTest, AResultThatIsGoneIsLost) {
  const SweepManifest manifest = manifestOf(two_masses + "keep: results\n");
  plan(manifest);
  record(manifest, 0, RunEnd::ok, "runs/0.h5");
  const TaskReason reason = reasons(manifest, 0, 1, 0)[0];
  EXPECT_EQ(reason.why, WhyRun::lost);
  EXPECT_EQ(reason.text, "lost: runs/0.h5 is gone or damaged");
}

TEST_F(WhyTest, OtherShardsAreNamed) {
  const SweepManifest manifest = manifestOf(two_masses);
  const SweepPlan of(manifest, folder_);
  const std::size_t first = of.shardOf(0, 2);
  const std::vector<TaskReason> said = reasons(manifest, first, 2);
  EXPECT_EQ(said[0].text, "no record of it");
  EXPECT_EQ(said[1].text, "not here: of shard " + std::to_string(2 - first) + "/2");
  EXPECT_FALSE(said[1].runs());
}

TEST_F(WhyTest, MoreValuesAreAdded) {
  const SweepManifest before = manifestOf(two_masses);
  plan(before);
  record(before, 0, RunEnd::ok);
  const SweepManifest now = manifestOf("axes: [{path: bodies.ball.mass_kg, values: [0.1, 0.2, 0.3]}]\n");
  EXPECT_EQ(texts(now),
            (Texts{"finished: ok", "no record of it", "added: the plan before has no such simulation"}));
}

TEST_F(WhyTest, WhatChangedIsNamed) {
  const SweepManifest before = manifestOf(two_masses);
  plan(before);
  record(before, 0, RunEnd::ok);
  const auto said = [&](const auto& change) {
    SweepManifest now = before;
    change(now);
    return texts(now).at(0);
  };
  const auto replace = [](std::string& text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(said([](SweepManifest& now) { now.engines["f64"] = "fnv1a64:2"; }),
            "changed: another build of fissure-engine-f64");
  EXPECT_EQ(said([](SweepManifest& now) { now.inputs["ball.obj"] = "fnv1a64:8"; }),
            "changed: another ball.obj");
  EXPECT_EQ(said([&](SweepManifest& now) { replace(now.scenario, "0.03", "0.04"); }),
            "changed: bodies.ball.shape.radius_m");
  EXPECT_EQ(said([&](SweepManifest& now) {
              replace(now.scenario, "duration_s: 1", "duration_s: 2, step_s: 0.001");
              replace(now.scenario, "k: 200", "k: 300");
              now.engines["f64"] = "fnv1a64:2";
            }),
            "changed: force.hc.k, time.duration_s, time.step_s, another build of fissure-engine-f64");
  EXPECT_EQ(said([](SweepManifest& now) { now.settings.keep = SweepKeep::results; }),
            "changed: results are kept now");
  EXPECT_EQ(said([](SweepManifest& now) {
              now.settings.curves = {{"force"}, 0.1, 1.0};
            }),
            "changed: other curves");
  SweepManifest described = before;
  described.settings.description = "other words";  // change nothing
  EXPECT_EQ(texts(described).at(0), "finished: ok");
}

TEST_F(WhyTest, MoreLawsOverOneSimulationAreAChange) {
  const std::string masses = "axes:\n  - {path: bodies.ball.mass_kg, values: [0.1]}\n";
  const SweepManifest before = manifestOf(masses + "  - {path: force.hc.k, values: [1, 2]}\n");
  plan(before);
  record(before, 0, RunEnd::ok);
  EXPECT_EQ(texts(manifestOf(masses + "  - {path: force.hc.k, values: [1, 2, 3]}\n")),
            (Texts{"changed: 3 sets of force laws, 2 before"}));
  EXPECT_EQ(texts(manifestOf(masses + "  - {path: force.hc.k, values: [1, 3]}\n")),
            (Texts{"changed: other coefficients of force laws"}));
}

TEST_F(WhyTest, DamagedPlansAndFoldersOfOthers) {
  const SweepManifest manifest = manifestOf(two_masses);
  writeFile(manifestFile(folder_), "{}");
  EXPECT_EQ(texts(manifest).at(0), "no record of it");
  SweepManifest other = manifest;
  other.settings.name = "other";
  plan(other);
  EXPECT_THROW(reasons(manifest), InputError);
  fs::remove(manifestFile(folder_));
  writeFile(folder_ / "thesis.txt", "mine");
  EXPECT_THROW(reasons(manifest), InputError);
}

TEST_F(WhyTest, RowsAndJsonSayTheSame) {
  const SweepManifest manifest = manifestOf(two_masses);
  const SweepPlan of(manifest, folder_);
  const std::vector<TaskReason> said = reasons(manifest);
  const auto rows = whyRows(of, said);
  EXPECT_EQ(rows.at(1), (std::vector<std::string>{of.tasks()[1].id, "default", "bodies.ball.mass_kg=0.2",
                                                  "no record of it"}));
  const nlohmann::ordered_json json = whyJson(of, said);
  EXPECT_EQ(json.at(1).at("simulation"), of.tasks()[1].id);
  EXPECT_EQ(json.at(1).at("why"), "no_record");
  EXPECT_EQ(json.at(1).at("runs"), true);
}

}  // namespace
}  // namespace fissure::sweep_why_test
