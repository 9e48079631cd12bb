#include "engine/simulation.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "engine/pipeline.h"
#include "scenario/catalog.h"
#include "stepping/stepped_state.h"

namespace fissure {

namespace {

constexpr auto factories = std::to_array<PipelineFactory>({
    {PipelineKind::default_sdf, nullptr, &makeSdfPipeline},
    {PipelineKind::null_sdf, &makeDelegatingConfiguration, &makeSdfPipeline},
    {PipelineKind::cluster, nullptr, &makeClusterPipeline},
    {PipelineKind::raycast, nullptr, &makeMethodPipeline},
    {PipelineKind::fukuhara, nullptr, &makeMethodPipeline},
    {PipelineKind::swept, nullptr, &makeMethodPipeline},
    {PipelineKind::prescribed, nullptr, &makePrescribedPipeline},
});

}  // namespace

const PipelineFactory& pipelineFactory(PipelineKind kind) {
  for (const PipelineFactory& factory : factories) {
    if (factory.kind == kind) return factory;
  }
  const auto index = static_cast<std::size_t>(kind);
  throw std::invalid_argument("no pipeline " +
                              (index < pipeline_table.size() ? std::string(pipeline_table[index].name)
                                                             : "number " + std::to_string(index)) +
                              " in this engine");
}

std::vector<PipelineKind> enginePipelines() {
  std::vector<PipelineKind> kinds = {PipelineKind::deformable};
  for (const PipelineFactory& factory : factories) kinds.push_back(factory.kind);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

Precision enginePrecision() {
  return sizeof(btScalar) == 8 ? Precision::f64 : Precision::f32;
}

std::string engineVersion() {
  const int version = btGetVersion();
  return fmt::format("Bullet {}.{}, {} precision", version / 100, version % 100,
                     enginePrecision() == Precision::f64 ? "double" : "single");
}

namespace {

std::vector<double> masses(const Scene& scene, const std::vector<double>& inverse_masses) {
  std::vector<double> masses_kg;
  for (const double inverse_mass : inverse_masses) masses_kg.push_back(1 / inverse_mass);
  for (const SceneBody& body : scene.bodies)
    for (const int vertex : body.fixed_vertices) masses_kg[body.first_vertex + vertex] = 0;
  for (std::size_t v = 0; v < masses_kg.size(); ++v) {
    if (!std::isfinite(masses_kg[v]) || !std::isfinite(inverse_masses[v]))
      throw InputError("bodies: the mass of a vertex or its inverse is no number in precision " +
                       nameIn(catalog().precisions, enginePrecision()) + ", expected another mass_kg");
  }
  return masses_kg;
}

class BulletSimulation final : public Simulation {
 public:
  BulletSimulation(const Scenario& scenario, const PipelineSettings& settings, const Scene& scene,
                   const std::vector<Pose>& first_poses)
      : step_s_(scenario.time.step_s),
        factory_(pipelineFactory(settings.pipeline)),
        world_(scenario, settings, scene, factory_.configuration ? factory_.configuration() : nullptr),
        pipeline_(factory_.make({scenario, settings, scene, world_, first_poses})),
        stepped_(scenario, scene, first_poses, masses(scene, world_.inverseMasses())) {
    collect();
  }

  using Simulation::step;
  void step(const std::vector<Pose>& poses, std::span<const double> tool_inverse_masses_1_kg) override {
    if (!tool_inverse_masses_1_kg.empty() && !pipeline_->pushesTools())
      throw std::invalid_argument("the contacts of this pipeline can push no tool");
    stepped_.beginStep(poses, tool_inverse_masses_1_kg);
    pipeline_->setToolBodies(stepped_.toolBodies());
    pipeline_->moveTools(stepped_.toolsBefore(), state().tools);
    world_.step();
    pipeline_->report(state(), stepped_.patch());
    movePushedTools();
    collect();
    stepped_.endStep();
  }

  void changeTempo(double factor) override {
    if (factor < 1) world_.scaleVelocities(factor);
  }

  State& state() override { return stepped_.state(); }
  const State& state() const override { return stepped_.state(); }
  Summary counters() const override { return pipeline_->counters(); }
  std::vector<StageTime> stageTimes() const override {
    std::vector<StageTime> stages = world_.stageTimes();
    for (StageTime& stage : pipeline_->stageTimes()) stages.push_back(std::move(stage));
    stepped_.addStageTimes(stages);
    return stages;
  }

 private:
  void movePushedTools() {
    const std::span<const ToolBody> bodies = stepped_.toolBodies();
    for (std::size_t t = 0; t < bodies.size(); ++t) {
      if (!(bodies[t].inverse_mass_1_kg > 0)) continue;
      state().tools[t].pose.position_m += bodies[t].offset_m;
      state().tools[t].velocity_m_s += bodies[t].motion_m / step_s_;
    }
  }

  void collect() {
    world_.readPositions(state().positions_m);
    world_.readVelocities(state().velocities_m_s);
  }

  double step_s_;
  const PipelineFactory& factory_;
  BulletWorld world_;
  std::unique_ptr<Pipeline> pipeline_;
  SteppedState stepped_;
};

}  // namespace

std::unique_ptr<Simulation> makeSimulation(const Scenario& scenario, const PipelineSettings& pipeline,
                                           const Scene& scene, const std::vector<Pose>& first_poses) {
  return std::make_unique<BulletSimulation>(scenario, pipeline, scene, first_poses);
}

}  // namespace fissure
