#include "engine/simulation.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "base/error.h"
#include "contact/triangle_forces.h"
#include "engine/pipeline.h"
#include "scenario/catalog.h"

namespace fissure {

namespace {

constexpr auto factories = std::to_array<PipelineFactory>({
    {PipelineKind::default_sdf, nullptr, &makeSdfPipeline},
    {PipelineKind::null_sdf, &makeDelegatingConfiguration, &makeSdfPipeline},
    {PipelineKind::cluster, nullptr, &makeClusterPipeline},
    {PipelineKind::raycast, nullptr, &makeNodePipeline},
    {PipelineKind::fukuhara, nullptr, &makeNodePipeline},
    {PipelineKind::swept, nullptr, &makeSweptPipeline},
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
  std::vector<PipelineKind> kinds;
  for (const PipelineFactory& factory : factories) kinds.push_back(factory.kind);
  return kinds;
}

Precision enginePrecision() {
  return sizeof(btScalar) == 8 ? Precision::f64 : Precision::f32;
}

std::string engineVersion() {
  const int version = btGetVersion();
  return "Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100) +
         (enginePrecision() == Precision::f64 ? ", double precision" : ", single precision");
}

namespace {

std::vector<TriangleLaw> makeLaws(const std::vector<ForceSettings>& settings) {
  std::vector<TriangleLaw> laws;
  for (const ForceSettings& law : settings)
    laws.push_back({.law = ForceLaw(law.model, law.coefficients),
                    .rate = law.rate,
                    .deformation = law.deformation,
                    .per_area = law.per_area});
  return laws;
}

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

class BulletSimulation : public Simulation {
 public:
  BulletSimulation(const Scenario& scenario, const PipelineSettings& settings, const Scene& scene,
                   const std::vector<Pose>& first_poses)
      : step_s_(scenario.time.step_s) {
    const PipelineFactory& factory = pipelineFactory(settings.pipeline);
    world_ = std::make_unique<BulletWorld>(scenario, settings, scene,
                                           factory.configuration ? factory.configuration() : nullptr);
    pipeline_ = factory.make({scenario, settings, scene, *world_, first_poses});
    if (!scenario.force.empty())
      forces_ = std::make_unique<TriangleForces>(scene, makeLaws(scenario.force), step_s_,
                                                 scenario.record.force_inputs);
    for (const Pose& pose : first_poses) state_.tools.push_back({.pose = pose});
    patch_.resize(scene.vertexCount(), scene.faceCount(), scenario.force.empty() ? 0 : scene.tools.size());
    patch_.clear();
    state_.positions_m.resize(scene.vertexCount());
    state_.velocities_m_s.resize(scene.vertexCount());
    state_.masses_kg = masses(scene, world_->inverseMasses());
    state_.contact.node_states.assign(scene.nodeCount(), NodeState::free);
    state_.contact.tool_reactions_N.assign(scene.tools.size() > 1 ? scene.tools.size() : 0, Vec3::Zero());
    state_.forces.assign(scenario.force.size(), ForceSample{});
    state_.tool_forces_N.assign(scenario.force.size() * scene.tools.size(), Vec3::Zero());
    collect();
  }

  void step(const std::vector<Pose>& poses) override {
    before_ = state_.tools;
    for (std::size_t t = 0; t < poses.size(); ++t) {
      ToolState& tool = state_.tools[t];
      const Eigen::AngleAxisd turn(poses[t].orientation * tool.pose.orientation.conjugate());
      tool.velocity_m_s = (poses[t].position_m - tool.pose.position_m) / step_s_;
      tool.angular_velocity_rad_s = turn.axis() * (turn.angle() / step_s_);
      tool.pose = poses[t];
    }
    pipeline_->moveTools(before_, state_.tools);
    world_->step();
    pipeline_->report(state_, patch_);
    collect();
    if (!forces_) return;
    StageClock clock;
    forces_->evaluate(patch_, state_);
    clock.lap(forces_s_);
  }

  State& state() override { return state_; }
  const State& state() const override { return state_; }
  Summary counters() const override { return pipeline_->counters(); }
  std::vector<StageTime> stageTimes() const override {
    std::vector<StageTime> stages = world_->stageTimes();
    for (StageTime& stage : pipeline_->stageTimes()) stages.push_back(std::move(stage));
    if (forces_) stages.push_back({"force_laws", forces_s_});
    return stages;
  }

 private:
  void collect() {
    world_->readPositions(state_.positions_m);
    world_->readVelocities(state_.velocities_m_s);
    state_.contact.vertex_contact = patch_.vertex_contact;
  }

  double step_s_;
  std::unique_ptr<BulletWorld> world_;
  std::unique_ptr<Pipeline> pipeline_;
  std::unique_ptr<TriangleForces> forces_;
  std::vector<ToolState> before_;
  ContactPatch patch_;
  double forces_s_ = 0;
  State state_;
};

}  // namespace

std::unique_ptr<Simulation> makeSimulation(const Scenario& scenario, const PipelineSettings& pipeline,
                                           const Scene& scene, const std::vector<Pose>& first_poses) {
  return std::make_unique<BulletSimulation>(scenario, pipeline, scene, first_poses);
}

}  // namespace fissure
