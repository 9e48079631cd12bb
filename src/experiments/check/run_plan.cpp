#include "check/run_plan.h"

#include <cmath>

#include "base/steps.h"
#include "measure/probes.h"
#include "scene/build_scene.h"

namespace fissure {

namespace {

double recordBytes(const CheckedScenario& checked, const RecordLayout& layout) {
  double row_bytes = 0;
  for (const Series& series : layout.series())
    row_bytes += static_cast<double>(series.columns) * (series.type == ValueType::flag ? 1 : 8);
  const Scenario& scenario = checked.loaded.scenario;
  return row_bytes *
         static_cast<double>(everyNth(checked.steps, stepsPerRow(scenario.record, scenario.measure)));
}

/// Size of the stored tetrahedra at rest: three coordinates and an index per vertex, four packed indices per
/// tetrahedron.
double volumeBytes(const Scene& scene) {
  constexpr double packed_bytes = 5;
  double bytes = 0;
  for (const SceneBody& body : scene.bodies)
    if (body.volume)
      bytes += 32.0 * static_cast<double>(body.volume->mesh.vertices_m.size()) +
               packed_bytes * static_cast<double>(body.volume->mesh.tetrahedra.size());
  return bytes;
}

/// The checked scene as the pipeline has it.
Scene sceneFor(const CheckedScenario& checked, const PipelineSettings& pipeline) {
  Scene scene = checked.prepared.scene;
  adaptTo(pipeline, scene);
  return scene;
}

RunPlan planRun(const CheckedScenario& checked, const PipelineSettings& pipeline) {
  const Scenario& scenario = checked.loaded.scenario;
  const Scene scene = sceneFor(checked, pipeline);
  const RecordLayout layout = declareLayout(makeProbes(scenario, scene));

  RunPlan plan;
  plan.pipeline = &pipeline;
  plan.settling_steps = std::llround(stepsToCover(scenario.time.settle_s, scenario.time.step_s));
  plan.steps = checked.steps;
  plan.nodes = scene.nodeCount();
  for (const Series& series : layout.series()) plan.series.push_back(series.name);
  plan.record_bytes = recordBytes(checked, layout);
  // Running number, triangle, area, direction; deformation and rate of each law.
  if (scenario.record.force_inputs)
    plan.force_input_bytes = 48 + 16 * static_cast<int>(scenario.force.size());
  if (scenario.record.snapshots_every_s) {
    plan.snapshots = timesDue(checked.steps, scenario.time.step_s, *scenario.record.snapshots_every_s);
    const double clamps = scene.hasHandles() ? static_cast<double>(scene.clamps.size()) : 0;
    // Time, positions, states and pressures; the poses of clamps.
    const bool elastic = scene.bodies.at(0).volume.has_value();
    const double one =
        8.0 + (elastic ? 33.0 : 25.0) * scene.vertexCount() + 1.0 * scene.nodeCount() + 56.0 * clamps;
    plan.snapshot_bytes = one * static_cast<double>(plan.snapshots) + volumeBytes(scene);
  }
  if (scenario.record.frames) {
    plan.frames = timesDue(checked.steps, scenario.time.step_s, scenario.record.frames->every_s);
    const double one = 3.0 * scenario.record.frames->width_px * scenario.record.frames->height_px;
    plan.frame_bytes = one * static_cast<double>(plan.frames);
  }
  return plan;
}

}  // namespace

RecordLayout layoutOf(const CheckedScenario& checked, const PipelineSettings& pipeline) {
  return declareLayout(makeProbes(checked.loaded.scenario, sceneFor(checked, pipeline)));
}

Summary emptySummaryOf(const CheckedScenario& checked, const PipelineSettings& pipeline) {
  const auto probes = makeProbes(checked.loaded.scenario, sceneFor(checked, pipeline));
  declareLayout(probes);
  Summary summary;
  for (const auto& probe : probes) probe->summarize(summary);
  return summary;
}

std::vector<RunPlan> planRuns(const CheckedScenario& checked) {
  std::vector<RunPlan> plans;
  for (const PipelineSettings& pipeline : checked.loaded.scenario.pipelines)
    plans.push_back(planRun(checked, pipeline));
  return plans;
}

}  // namespace fissure
