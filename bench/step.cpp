// A simulated step, with nothing looking on.
#include <map>
#include <variant>

#include "base/steps.h"
#include "batch.h"
#include "cases.h"
#include "engine/simulation.h"
#include "explicit/elastic_simulation.h"
#include "motion/motion.h"
#include "scene/build_scene.h"

namespace fissure::bench {

namespace {

constexpr int kSteps = 200;

/// Steps from time zero to just before the first contact in any of the scenario's pipelines, on any mesh.
int stepsBeforeContact(const std::string& scenario) {
  if (scenario == "plate_press") return 33;
  return scenario == "elastic_press" ? 30 : 54;
}

std::unique_ptr<Simulation> makeWorld(const Scenario& scenario, const PipelineSettings& pipeline,
                                      const Scene& scene, const std::vector<Pose>& first_poses) {
  return scenario.bodies[0].isElastic() ? makeElasticSimulation(scenario, pipeline, scene, first_poses)
                                        : makeSimulation(scenario, pipeline, scene, first_poses);
}

/// Totals of a simulation, which grow with its steps.
std::map<std::string, double> countsOf(const Simulation& simulation) {
  std::map<std::string, double> counts;
  for (const SummaryValue& counter : simulation.counters())
    counts[counter.name] = static_cast<double>(std::get<long long>(counter.value));
  return counts;
}

/// Median time of each stage of a step, from totals before the first step and after each.
std::map<std::string, double> stagesOf(const std::vector<std::vector<StageTime>>& totals) {
  std::map<std::string, double> stages_s;
  for (std::size_t s = 0; s < totals.front().size(); ++s) {
    std::vector<double> times_s;
    for (std::size_t i = 1; i < totals.size(); ++i)
      times_s.push_back(totals[i][s].total_s - totals[i - 1][s].total_s);
    stages_s[totals.front()[s].name] = median(times_s);
  }
  return stages_s;
}

/// The median of kSteps steps of a new simulation, stepped as a Run does it.
double measureSteps(benchmark::State& out, const Scenario& scenario, const PipelineSettings& pipeline) {
  const Scene scene = buildScene(scenario, pipeline.usesNodes());
  std::vector<std::unique_ptr<Motion>> motions;
  for (const ToolSettings& tool : scenario.tools) motions.push_back(makeMotion(tool, scenario.directory));
  const auto poses_at = [&](int step) {
    std::vector<Pose> poses;
    poses.reserve(motions.size());
    for (const auto& motion : motions) poses.push_back(motion->poseAt(step * scenario.time.step_s));
    return poses;
  };
  const auto simulation = makeWorld(scenario, pipeline, scene, poses_at(0));
  const State& state = simulation->state();
  const int settling = static_cast<int>(stepsToCover(scenario.time.settle_s, scenario.time.step_s));
  for (int i = 0; i < settling; ++i) simulation->step(poses_at(0));
  const int first = stepsBeforeContact(scenario.name) + 1;
  for (int step = 1; step < first; ++step) simulation->step(poses_at(step));
  if (state.contact.contact_count != 0) throw std::logic_error("contact before the first measured step");

  const auto counts_before = countsOf(*simulation);
  double contacts = 0;
  Batch steps;
  std::vector<std::vector<StageTime>> stages = {simulation->stageTimes()};
  for (int step = first; step < first + kSteps; ++step) {
    const std::vector<Pose> poses = poses_at(step);
    steps.time([&] { simulation->step(poses); });
    stages.push_back(simulation->stageTimes());
    contacts += state.contact.contact_count;
  }
  for (const auto& [name, count] : countsOf(*simulation))
    out.counters[name] = (count - counts_before.at(name)) / kSteps;
  for (const auto& [name, stage_s] : stagesOf(stages)) out.counters[name + "_us"] = 1e6 * stage_s;
  out.counters["contacts"] = contacts / kSteps;
  out.counters["allocations"] = steps.allocationCount() / kSteps;
  return steps.median_s();
}

}  // namespace

void addStepCases() {
  for (const std::string name : {"spatula_press", "plate_press", "elastic_press", "elastic_organ"}) {
    const Scenario scenario = configuredScenario(name);
    for (const PipelineSettings& pipeline : scenario.pipelines) {
      addCase("step/" + name + "/" + pipeline.name,
              [=](benchmark::State& out) { return measureSteps(out, scenario, pipeline); });
    }
  }
  for (const int subdivisions : {4, 5}) {  // plate_press has 3
    const Scenario scenario = configuredScenario(
        "plate_press", {{"bodies.sphere.shape.subdivisions", std::to_string(subdivisions)}});
    const std::string triangles = std::to_string(8 << 2 * subdivisions);
    for (const PipelineSettings& pipeline : scenario.pipelines)
      if (pipeline.name == "default_tuned" || pipeline.name == "swept")
        addCase("step/plate_press_" + triangles + "/" + pipeline.name,
                [=](benchmark::State& out) { return measureSteps(out, scenario, pipeline); });
  }
}

}  // namespace fissure::bench
