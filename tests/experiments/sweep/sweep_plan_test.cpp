#include "sweep/sweep_plan.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>

#include "base/error.h"
#include "sweep_text.h"

namespace fissure::sweep_plan_test {

namespace {

const std::string scenario =
    "{format: 1, name: press, bodies: [{name: ball, shape: {type: sphere, radius_m: 0.03, subdivisions: 1}, "
    "mass_kg: 0.1}], tools: [{name: blade, shape: {type: box, size_m: [0.04, 0.002, 0.015]}, motion: {type: "
    "script, start_m: [0, 0.06, 0], segments: [{hold_s: 1}]}}], pipelines: [{pipeline: default}, {pipeline: "
    "fukuhara}, {name: single, pipeline: default, precision: f32}], force: [{name: hc, model: "
    "hunt_crossley}, "
    "{name: lin, model: linear_elastic}]}";

SweepManifest manifestOf(const std::string& sweep, const std::string& base = scenario) {
  SweepManifest manifest;
  manifest.settings = sweepOf(sweep);
  manifest.scenario = base;
  manifest.directory = "somewhere";
  manifest.engines = {{"f64", "fnv1a64:1"}, {"f32", "fnv1a64:2"}};
  manifest.pipelines = {"default", "fukuhara", "single"};
  manifest.points = SweepPoints(manifest.settings);
  return manifest;
}

SweepPlan planOf(const std::string& sweep, const std::string& base = scenario) {
  return {manifestOf(sweep, base), "folder"};
}

std::set<std::string> idsOf(const SweepPlan& plan) {
  std::set<std::string> ids;
  for (const SweepTask& task : plan.tasks()) ids.insert(task.id);
  EXPECT_EQ(ids.size(), plan.tasks().size());
  return ids;
}

const std::string three_axes =
    "axes:\n"
    "  - {path: bodies.ball.mass_kg, values: [0.1, 0.2]}\n"
    "  - {path: force.hc.k, values: [1, 2, 3]}\n"
    "  - {path: force.lin.k, values: [10, 20]}\n";

TEST(SweepPlan, LawsShareTheirSimulation) {
  const SweepPlan plan = planOf(three_axes);
  EXPECT_EQ(plan.runs(), 2u * 3 * 2 * 3);
  ASSERT_EQ(plan.tasks().size(), 2u * 3);
  EXPECT_EQ(plan.tasks().front().laws.size(), 6u);
  EXPECT_FALSE(plan.isLawAxis(0));
  EXPECT_TRUE(plan.isLawAxis(1) && plan.isLawAxis(2));
  // Each run has the laws of its own point and the physics of one like it.
  for (std::size_t i = 0; i < plan.runs(); ++i) {
    const PlannedRun run = plan.run(i);
    EXPECT_EQ(run.point, i / 3);
    const SweepTask& task = plan.tasks()[run.task];
    EXPECT_EQ(task.entry, run.entry);
    EXPECT_EQ(plan.lawsAt(task.laws[run.law]), plan.lawsAt(run.point));
    EXPECT_EQ(plan.manifest().points.value(task.point, 0), plan.manifest().points.value(run.point, 0));
  }
  EXPECT_EQ(plan.lawsAt(11)[0].coefficients.k, 3);
  EXPECT_EQ(plan.lawsAt(11)[1].coefficients.k, 20);
  const std::vector<Override> overrides = plan.overrides(plan.tasks().back());
  ASSERT_EQ(overrides.size(), 1u);  // the laws are evaluated beside the scenario's own
  EXPECT_EQ(overrides[0].path, "bodies.ball.mass_kg");
}

TEST(SweepPlan, EveryCoefficientOfEveryLawMovesNothing) {
  for (const ForceLawEntry& law : forceLaws()) {
    for (const LawCoefficient& of : law.coefficients) {
      const std::string base = scenario.substr(0, scenario.find("force: [")) +
                               "force: [{name: own, model: " + std::string(law.name) + "}]}";
      const SweepPlan plan =
          planOf("axes: [{path: force.own." + std::string(of.name) + ", values: [1, 2, 4]}]\n", base);
      EXPECT_TRUE(plan.isLawAxis(0)) << law.name << " " << of.name;
      EXPECT_EQ(plan.tasks().size(), 3u) << "one for each pipeline";
      EXPECT_EQ(plan.lawsAt(2)[0].coefficients.*of.member, 4) << law.name << " " << of.name;
    }
  }
}

TEST(SweepPlan, WhatMayMoveSomethingIsSimulated) {
  const std::string k = "axes:\n  - {path: force.hc.k, values: [1, 2]}\n";
  EXPECT_EQ(planOf(k).tasks().size(), 3u);
  for (const char* more : {"  - {path: force.hc.deformation, values: [paper, corotated]}\n",
                           "  - {path: force.1.model, values: [linear_elastic, kelvin_voigt]}\n",
                           "  - {path: tools.blade.coupling.mass_kg, values: [0.1, 0.2]}\n"})
    EXPECT_EQ(planOf(k + more).tasks().size(), 12u) << more;
  std::string coupled = scenario;
  coupled.insert(coupled.find("motion:"),
                 "coupling: {mass_kg: 0.05, stiffness_N_m: 3000, damping_N_s_m: 20, force: hc}, ");
  EXPECT_EQ(planOf(k, coupled).tasks().size(), 6u);
  coupled.replace(coupled.find("force: hc}"), 9, "force: reaction");
  const std::string pipelines = "pipelines: [{pipeline: default}, {pipeline: fukuhara}";
  coupled.replace(coupled.find(pipelines), pipelines.size(),
                  "pipelines: [{name: default, pipeline: swept}, {pipeline: fukuhara}");
  const std::string single = "{name: single, pipeline: default";
  coupled.replace(coupled.find(single), single.size(), "{name: single, pipeline: swept");
  EXPECT_EQ(planOf(k, coupled).tasks().size(), 3u) << "no law moves it";
}

TEST(SweepPlan, AnEntryIsOnlyRunAgainForWhatItReads) {
  const SweepPlan plan = planOf(
      "axes:\n  - {path: pipelines.fukuhara.sweeps, values: [1, 2, 4]}\n"
      "  - {path: pipelines.0.settings, values: [stock, tuned]}\n");
  EXPECT_EQ(plan.runs(), 18u);
  EXPECT_EQ(plan.tasks().size(), 2u + 3 + 1);
  for (const SweepTask& task : plan.tasks())
    EXPECT_EQ(plan.overrides(task).size(), task.entry == 2 ? 0u : 1u);
}

TEST(SweepPlan, EqualNumbersAreOneRunHoweverTheyAreWritten) {
  EXPECT_EQ(planOf("axes: [{zip: [{path: bodies.ball.mass_kg, values: [0.1, 1e-1, 0.10, 0.2]}, "
                   "{path: force.hc.k, values: [1, 2, 3, 4]}]}]\n")
                .tasks()
                .size(),
            6u);
}

TEST(SweepPlan, TasksAreKnownByTheirContents) {
  const std::set<std::string> ids = idsOf(planOf(three_axes));
  EXPECT_EQ(idsOf(planOf(three_axes)), ids);
  // In another order, and with one value more: the old simulations keep their names.
  const std::set<std::string> more = idsOf(
      planOf("axes:\n  - {path: force.lin.k, values: [20, 10]}\n  - {path: bodies.ball.mass_kg, values: "
             "[0.3, 0.2, 0.1]}\n  - {path: force.hc.k, values: [3, 1, 2]}\n"));
  EXPECT_EQ(more.size(), 9u);
  for (const std::string& id : ids) EXPECT_TRUE(more.contains(id));
  const std::set<std::string> two =
      idsOf(planOf("axes: [{path: bodies.ball.mass_kg, values: [0.1, 0.2]}]\n"));
  const std::set<std::string> three =
      idsOf(planOf("axes: [{path: bodies.ball.mass_kg, values: [0.3, 0.2, 0.1]}]\n"));
  for (const std::string& id : two) EXPECT_TRUE(three.contains(id));

  const auto changed = [&](const std::function<void(SweepManifest&)>& change) {
    SweepManifest manifest = manifestOf(three_axes);
    change(manifest);
    const std::set<std::string> others = idsOf({manifest, "folder"});
    std::size_t kept = 0;
    for (const std::string& id : others) kept += ids.contains(id);
    return others.size() - kept;
  };
  EXPECT_EQ(changed([](SweepManifest&) {}), 0u);
  EXPECT_EQ(changed([](SweepManifest& m) { m.directory = "elsewhere"; }), 0u);
  EXPECT_EQ(changed([](SweepManifest& m) { m.settings.limits.time_s = 3; }), 0u);
  EXPECT_EQ(changed([](SweepManifest& m) { m.engines["f32"] = "fnv1a64:3"; }), 2u);
  EXPECT_EQ(changed([](SweepManifest& m) { m.inputs["liver.obj"] = "fnv1a64:4"; }), 6u);
  EXPECT_EQ(changed([](SweepManifest& m) { m.settings.repeats = 2; }), 6u);
  const auto edit = [](SweepManifest& m, const std::string& from, const std::string& to) {
    m.scenario.replace(m.scenario.find(from), from.size(), to);
  };
  EXPECT_EQ(changed([&](SweepManifest& m) { edit(m, "name: press", "description: a press, name: press"); }),
            0u);
  EXPECT_EQ(changed([&](SweepManifest& m) { edit(m, "radius_m: 0.03", "radius_m: 0.031"); }), 6u);
  EXPECT_EQ(
      changed([&](SweepManifest& m) { edit(m, "pipeline: fukuhara", "pipeline: fukuhara, sweeps: 9"); }), 2u);
  EXPECT_EQ(changed([](SweepManifest& m) { m.settings.curves = SweepCurves{{"force"}, 0.1, 1}; }), 6u);
  EXPECT_EQ(changed([](SweepManifest& m) { m.settings.keep = SweepKeep::results; }), 6u);
}

TEST(SweepPlan, AFileThatAnAxisNamesIsOnlyItsOwnPointsBusiness) {
  SweepManifest manifest = manifestOf("axes: [{path: bodies.ball.shape.file, values: [a.obj, b/c.obj]}]\n");
  manifest.inputs = {{"a.obj", "fnv1a64:7"}, {"b/c.obj", "fnv1a64:8"}};
  manifest.axis_inputs = {"a.obj", "b/c.obj"};
  const std::set<std::string> ids = idsOf({manifest, "folder"});
  manifest.inputs["b/c.obj"] = "fnv1a64:9";
  std::size_t kept = 0;
  for (const std::string& id : idsOf({manifest, "folder"})) kept += ids.contains(id);
  EXPECT_EQ(kept, 3u);
}

TEST(SweepPlan, ShardsAreEvenAndMixEntries) {
  const SweepPlan plan =
      planOf("axes: [{path: bodies.ball.mass_kg, linear: {from: 0.1, to: 0.2, count: 60}}]\n");
  std::vector<std::vector<std::size_t>> entries(3, std::vector<std::size_t>(3, 0));
  for (std::size_t t = 0; t < plan.tasks().size(); ++t) ++entries[plan.shardOf(t, 3)][plan.tasks()[t].entry];
  for (const std::vector<std::size_t>& shard : entries) {
    EXPECT_EQ(shard[0] + shard[1] + shard[2], 60u);
    for (const std::size_t of_entry : shard) EXPECT_GT(of_entry, 5u);
  }
}

TEST(SweepPlan, ItsPrecisionMayBeAnAxis) {
  const SweepPlan plan = planOf("axes: [{path: pipelines.fukuhara.precision, values: [f64, f32]}]\n");
  ASSERT_EQ(plan.tasks().size(), 4u);
  std::multiset<std::string> precisions;
  for (const SweepTask& task : plan.tasks()) precisions.insert(plan.precision(task));
  EXPECT_EQ(precisions.count("f32"), 2u);
}

TEST(SweepPlan, ALawsCoefficientMustBeANumber) {
  const SweepPlan plan = planOf("axes: [{path: force.hc.k, values: [soft]}]\n");
  EXPECT_THROW(plan.lawsAt(0), InputError);
}

class ManifestTest : public testing::Test {
 protected:
  ManifestTest()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("fissure_manifest_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ManifestTest() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& text) const { std::ofstream(manifestFile(folder_)) << text; }
  std::filesystem::path folder_;
};

TEST_F(ManifestTest, ReadsBackAsItWas) {
  SweepManifest manifest = manifestOf(
      three_axes +
      "repeats: 2\nkeep: results\nlimits: {time_s: 2.5}\ncurves: {quantities: [force], every_s: 0.1}\n");
  manifest.settings.curves->until_s = 1.0 / 3;
  manifest.curves = {{"force", "N", "magnitude", true}};
  manifest.inputs["a b.obj"] = "fnv1a64:5";
  manifest.settings.fit = SweepFit{"a.csv", "depth=1:mm,force=2:N", MatchBy::time, "lin", false};
  manifest.measured = "d,f\n1,2\n";
  write(manifestText(manifest));
  const SweepManifest back = readManifest(folder_);
  EXPECT_EQ(manifestText(back), manifestText(manifest));
  EXPECT_EQ(back.settings.curves->until_s, 1.0 / 3);
  EXPECT_EQ(back.settings.keep, SweepKeep::results);
  EXPECT_EQ(back.settings.limits.time_s, 2.5);
  EXPECT_FALSE(back.settings.limits.memory_mib);
  EXPECT_EQ(back.settings.fit->match, MatchBy::time);
  EXPECT_EQ(back.settings.fit->law, "lin");
  EXPECT_EQ(back.measured, "d,f\n1,2\n");
  EXPECT_EQ(idsOf({back, "folder"}), idsOf({manifest, "folder"}));
}

TEST_F(ManifestTest, CutOrChangedItIsRefused) {
  EXPECT_THROW(readManifest(folder_), InputError);
  const std::string text = manifestText(manifestOf(three_axes));
  for (std::size_t size = 0; size + 2 < text.size(); size += 97) {
    write(text.substr(0, size));
    EXPECT_THROW(readManifest(folder_), InputError) << size;
  }
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    write(changed);
    EXPECT_THROW(readManifest(folder_), InputError) << to;
  };
  refused("\"format_version\":1", "\"format_version\":2");
  refused("fissure-sweep-plan", "fissure-result");
  refused("\"repeats\":1", "\"repeats\":0");
  refused("\"points\":[0,", "\"points\":[99,");
  refused("\"points\":[0,", "\"points\":[");
}

}  // namespace
}  // namespace fissure::sweep_plan_test
