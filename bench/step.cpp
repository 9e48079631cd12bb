#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "cases.h"
#include "engine/simulation.h"
#include "motion/motion.h"
#include "run/build_scene.h"

namespace fissure::bench {

namespace {

constexpr int kSteps = 200;

/// Steps from time zero to just before the first contact in any of the scenario's pipelines.
int stepsBeforeContact(const std::string& scenario) {
  return scenario == "plate_press" ? 33 : 54;
}

struct Batch {
  std::map<std::string, double> counts;  ///< mean of a step
  double step_s = 0;                     ///< median
  double collision_s = 0;                ///< median
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A new simulation, stepped as a Run does it with nothing looking on.
Batch runBatch(const Scenario& scenario, const PipelineSettings& pipeline) {
  const Scene scene = buildScene(scenario, pipeline.usesNodes());
  std::vector<std::unique_ptr<Motion>> motions;
  for (const ToolSettings& tool : scenario.tools) motions.push_back(makeMotion(tool, scenario.directory));
  const auto poses_at = [&](int step) {
    std::vector<Pose> poses;
    poses.reserve(motions.size());
    for (const auto& motion : motions) poses.push_back(motion->poseAt(step * scenario.time.step_s));
    return poses;
  };
  const auto simulation = makeSimulation(scenario, pipeline, scene, poses_at(0));
  const State& state = simulation->state();
  const int settling = static_cast<int>(std::ceil(scenario.time.settle_s / scenario.time.step_s - 1e-9));
  for (int i = 0; i < settling; ++i) simulation->step(poses_at(0));
  const int first = stepsBeforeContact(scenario.name) + 1;
  for (int step = 1; step < first; ++step) simulation->step(poses_at(step));
  if (state.contact_count != 0) throw std::logic_error("contact before the first measured step");

  Batch batch;
  const auto count = [&](double sign) {
    for (const SummaryValue& counter : simulation->counters()) {
      batch.counts[counter.name] += sign * static_cast<double>(std::get<long long>(counter.value)) / kSteps;
    }
  };
  count(-1);
  std::vector<double> steps_s, collisions_s;
  for (int step = first; step < first + kSteps; ++step) {
    const std::vector<Pose> poses = poses_at(step);
    steps_s.push_back(secondsOf([&] { simulation->step(poses); }));
    collisions_s.push_back(1e-6 * state.timing.collision_us);
    batch.counts["contacts"] += static_cast<double>(state.contact_count) / kSteps;
  }
  count(+1);
  batch.step_s = median(steps_s);
  batch.collision_s = median(collisions_s);
  return batch;
}

void measureSteps(benchmark::State& state, const Scenario& scenario, const PipelineSettings& pipeline) {
  Batch batch;
  double collision_share = 0;
  for (auto _ : state) {
    const auto counts_before = std::exchange(batch, runBatch(scenario, pipeline)).counts;
    if (!counts_before.empty() && counts_before != batch.counts) {
      throw std::logic_error("two batches met different contacts");
    }
    state.SetIterationTime(batch.step_s);
    collision_share += batch.collision_s / batch.step_s;
  }
  for (const auto& [name, value] : batch.counts) state.counters[name] = value;
  state.counters["collision_share"] = {collision_share, benchmark::Counter::kAvgIterations};
}

}  // namespace

void addStepCases() {
  for (const std::string name : {"spatula_press", "plate_press"}) {
    const Scenario scenario = configuredScenario(name);
    for (const PipelineSettings& pipeline : scenario.pipelines) {
      addCase("step/" + name + "/" + pipeline.name,
              [=](benchmark::State& state) { measureSteps(state, scenario, pipeline); })
          ->UseManualTime()
          ->Iterations(3);
    }
  }
}

}  // namespace fissure::bench
