#include <algorithm>
#include <cmath>
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
  return scenario == "plate_press" ? 33 : 55;
}

/// A scenario's world from its start, stepped as a Run does, with nothing looking on.
class FreshWorld {
 public:
  FreshWorld(const Scenario& scenario, const PipelineSettings& pipeline)
      : step_s_(scenario.time.step_s), scene_(buildScene(scenario, usesToolNodes(pipeline.pipeline))) {
    for (const ToolSettings& tool : scenario.tools) motions_.push_back(makeMotion(tool, scenario.directory));
    simulation_ = makeSimulation(scenario, pipeline, scene_, posesAt(0));
    const int settling = static_cast<int>(std::ceil(scenario.time.settle_s / step_s_ - 1e-9));
    for (int i = 0; i < settling; ++i) simulation_->step(posesAt(0));
  }

  /// Wall time of the step, seconds.
  double advance() {
    const std::vector<Pose> poses = posesAt(++step_ * step_s_);
    return secondsOf([&] { simulation_->step(poses); });
  }
  const State& state() const { return simulation_->state(); }
  /// Of the detector since the start; 0 for Bullet's own, which counts nothing.
  double counted(const std::string& name) const {
    for (const SummaryValue& counter : simulation_->counters()) {
      if (counter.name == name) return static_cast<double>(std::get<long long>(counter.value));
    }
    return 0;
  }

 private:
  std::vector<Pose> posesAt(double time_s) const {
    std::vector<Pose> poses;
    for (const auto& motion : motions_) poses.push_back(motion->poseAt(time_s));
    return poses;
  }

  double step_s_;
  Scene scene_;
  std::vector<std::unique_ptr<Motion>> motions_;
  std::unique_ptr<Simulation> simulation_;
  int step_ = 0;
};

struct Counts {
  double contacts = 0, rays = 0, ray_triangle_tests = 0;  ///< mean of a step
  bool operator==(const Counts&) const = default;
};

struct Batch {
  Counts counts;
  double median_step_s = 0;
  double collision_share = 0;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Batch runBatch(const Scenario& scenario, const PipelineSettings& pipeline) {
  FreshWorld world(scenario, pipeline);
  for (int i = 0; i < stepsBeforeContact(scenario.name); ++i) world.advance();
  if (world.state().contact_count != 0) throw std::logic_error("contact before the first measured step");
  const double rays = world.counted("rays"), tests = world.counted("ray_triangle_tests");

  std::vector<double> steps_s, collisions_s;
  double contacts = 0;
  for (int i = 0; i < kSteps; ++i) {
    steps_s.push_back(world.advance());
    collisions_s.push_back(1e-6 * world.state().timing.collision_us);
    contacts += world.state().contact_count;
  }
  return {.counts = {.contacts = contacts / kSteps,
                     .rays = (world.counted("rays") - rays) / kSteps,
                     .ray_triangle_tests = (world.counted("ray_triangle_tests") - tests) / kSteps},
          .median_step_s = median(steps_s),
          .collision_share = median(collisions_s) / median(steps_s)};
}

void measureSteps(benchmark::State& state, const Scenario& scenario, const PipelineSettings& pipeline) {
  std::optional<Counts> first;
  double collision_share = 0;
  for (auto _ : state) {
    const Batch batch = runBatch(scenario, pipeline);
    state.SetIterationTime(batch.median_step_s);
    collision_share += batch.collision_share;
    if (!first) first = batch.counts;
    if (batch.counts != *first) throw std::logic_error("two batches met different contacts");
  }
  state.counters["collision_share"] = {collision_share, benchmark::Counter::kAvgIterations};
  state.counters["contacts"] = first->contacts;
  state.counters["rays"] = first->rays;
  state.counters["ray_triangle_tests"] = first->ray_triangle_tests;
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
