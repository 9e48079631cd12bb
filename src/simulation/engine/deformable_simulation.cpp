#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/convert.h"
#include "engine/deformable_touch.h"
#include "engine/deformable_world.h"
#include "engine/simulation.h"
#include "stepping/contact_pressure.h"
#include "stepping/elastic_model.h"
#include "stepping/stepped_state.h"
#include "stepping/tool_between.h"

namespace fissure {

namespace {

/// Into how many of Bullet's steps a step is cut.
class SubstepCount {
 public:
  SubstepCount(const PipelineSettings& settings, const BodySettings& body, const SceneBody& scene_body)
      : given_(settings.deformable.substeps) {
    if (!given_ && settings.settings == SettingsPreset::tuned)
      tissue_.emplace(makeTissue(body, scene_body, Vec3::Zero()));
  }

  int of(double step_s, DeformableWorld& world) {
    if (given_) return *given_;
    if (!tissue_) return static_cast<int>(std::ceil(step_s / kStockStep_s - 1e-9));
    const std::span<Vec3> positions_m = tissue_->positions_m();
    for (std::size_t v = 0; v < positions_m.size(); ++v)
      positions_m[v] = fromBullet(world.body().m_nodes[world.nodeOfVertex()[v]].m_x);
    return tissue_->substepsFor(step_s);
  }

  void changeTempo(double factor) {
    if (tissue_) tissue_->changeTempo(factor);
  }

 private:
  static constexpr double kStockStep_s = 1.0 / 240;  // of Bullet's examples
  std::optional<int> given_;
  std::optional<ElasticTissue> tissue_;  ///< only to ask it for the largest stable step
};

/// An elastic body in Bullet's own deformable world, with Bullet's own contact. Bullet does not say what its
/// contacts gave the tissue: here that is what of the momentum of the vertices in contact neither elements
/// nor gravity account for, elements at the end of an implicit step, at the start of an explicit one.
class DeformableSimulation final : public Simulation {
 public:
  DeformableSimulation(const Scenario& scenario, const PipelineSettings& settings, const Scene& scene,
                       const std::vector<Pose>& first_poses)
      : step_s_(scenario.time.step_s),
        elastic_(scenario.bodies.at(0).elastic),
        implicit_(*settings.deformableSolver(elastic_.material).implicit),
        substeps_(settings, scenario.bodies.at(0), scene.bodies.at(0)),
        gravity_m_s2_(scenario.world.gravity_m_s2),
        world_(scenario, settings, scene, first_poses),
        touch_(world_, scene),
        stepped_(scenario, scene, first_poses, surfaceMasses(scene)),
        rest_m_(scene.bodies[0].volume->mesh.vertices_m),
        impulses_N_s_(scene.vertexCount(), Vec3::Zero()),
        substep_impulses_N_s_(scene.vertexCount(), Vec3::Zero()),
        pressure_(scene.bodies[0].rest.faces) {
    state().volume.emplace();
    if (scenario.ground) state().contact.ground_reaction_N = Vec3::Zero();
    const int nodes = world_.body().m_nodes.size();
    velocities_before_.resize(nodes, btVector3(0, 0, 0));
    element_impulses_.resize(nodes, btVector3(0, 0, 0));
    collect();
  }

  using Simulation::step;
  void step(const std::vector<Pose>& poses, std::span<const double> tool_inverse_masses_1_kg) override {
    if (!tool_inverse_masses_1_kg.empty())
      throw std::invalid_argument("the contacts of this pipeline can push no tool");
    stepped_.beginStep(poses, {});
    const double detection_s = world_.detection_s();
    beginOutcome();
    std::fill(impulses_N_s_.begin(), impulses_N_s_.end(), Vec3::Zero());
    StageClock clock;
    const int substeps = substeps_.of(step_s_, world_);
    clock.lap(critical_step_s_);
    for (int i = 1; i <= substeps; ++i) substep(static_cast<double>(i) / substeps, step_s_ / substeps);
    endOutcome(substeps);
    state().timing.collision_us = 1e6 * (world_.detection_s() - detection_s);
    collect();
    state().volume->substeps = substeps;
    stepped_.endStep();
  }

  void changeTempo(double factor) override {
    substeps_.changeTempo(factor);
    if (factor >= 1) return;
    btSoftBody& body = world_.body();
    for (int i = 0; i < body.m_nodes.size(); ++i) body.m_nodes[i].m_v *= static_cast<btScalar>(factor);
  }

  State& state() override { return stepped_.state(); }
  const State& state() const override { return stepped_.state(); }
  Summary counters() const override { return {}; }
  std::vector<StageTime> stageTimes() const override {
    std::vector<StageTime> stages = {{"critical_step", critical_step_s_}};
    for (StageTime& stage : world_.stageTimes()) stages.push_back(std::move(stage));
    stages.push_back({"balance", balance_s_});
    stepped_.addStageTimes(stages);
    return stages;
  }

 private:
  std::vector<double> surfaceMasses(const Scene& scene) {
    std::vector<double> masses_kg(scene.vertexCount());
    for (std::size_t v = 0; v < masses_kg.size(); ++v)
      masses_kg[v] = world_.body().getMass(world_.nodeOfVertex()[v]);
    return masses_kg;
  }

  void beginOutcome() {
    ContactOutcome& outcome = state().contact;
    outcome.reaction_on_tool_N = Vec3::Zero();
    std::fill(outcome.tool_reactions_N.begin(), outcome.tool_reactions_N.end(), Vec3::Zero());
    if (outcome.ground_reaction_N) outcome.ground_reaction_N = Vec3::Zero();
    outcome.tool_work_J = 0;
  }

  /// Forces of the substeps become their mean.
  void endOutcome(int substeps) {
    ContactOutcome& outcome = state().contact;
    outcome.reaction_on_tool_N /= substeps;
    for (Vec3& force_N : outcome.tool_reactions_N) force_N /= substeps;
    if (outcome.ground_reaction_N) *outcome.ground_reaction_N /= substeps;
    outcome.candidate_count = touch_.candidates();
    outcome.contact_count = touch_.bearing();
    state().volume->tool_work_J += outcome.tool_work_J;
  }

  void substep(double share, double substep_s) {
    const btSoftBody& body = world_.body();
    for (int i = 0; i < body.m_nodes.size(); ++i) {
      velocities_before_[i] = body.m_nodes[i].m_v;
      element_impulses_[i].setZero();
    }
    const btScalar dt_s = static_cast<btScalar>(substep_s);
    if (!implicit_) world_.elasticity().addScaledExplicitForce(dt_s, element_impulses_);
    const std::vector<ToolState>& to = state().tools;
    tools_.resize(to.size());
    for (std::size_t t = 0; t < to.size(); ++t)
      tools_[t] = share < 1 ? between(stepped_.toolsBefore()[t], to[t], share) : to[t];
    world_.step(tools_, substep_s);
    StageClock clock;
    world_.body().updateDeformation();
    if (implicit_)
      world_.elasticity().addScaledForces(dt_s, element_impulses_);
    else
      world_.elasticity().addScaledDampingForce(dt_s, element_impulses_);
    touch_.read(stepped_.patch());
    balance(substep_s);
    clock.lap(balance_s_);
  }

  /// What contacts gave the vertices in the substep.
  void balance(double substep_s) {
    const btSoftBody& body = world_.body();
    double contact_work_J = 0;
    positions_m_.resize(substep_impulses_N_s_.size());
    for (std::size_t v = 0; v < substep_impulses_N_s_.size(); ++v) {
      const int i = world_.nodeOfVertex()[v];
      const btSoftBody::Node& node = body.m_nodes[i];
      positions_m_[v] = fromBullet(node.m_x);
      substep_impulses_N_s_[v].setZero();
      if (!(node.m_im > 0) || !touch_.touches(v)) continue;
      const Vec3 before_m_s = fromBullet(velocities_before_[i]), now_m_s = fromBullet(node.m_v);
      const Vec3 gained_m_s = now_m_s - before_m_s - substep_s * gravity_m_s2_;
      substep_impulses_N_s_[v] = gained_m_s / node.m_im - fromBullet(element_impulses_[i]);
      impulses_N_s_[v] += substep_impulses_N_s_[v];
      contact_work_J += substep_impulses_N_s_[v].dot(before_m_s + now_m_s) / 2;
    }
    state().volume->contact_work_J += contact_work_J;
    touch_.addForces({positions_m_, substep_impulses_N_s_}, tools_, substep_s, state().contact);
  }

  void collect() {
    const btSoftBody& body = world_.body();
    VolumeState& volume = *state().volume;
    volume.momentum_kg_m_s.setZero();
    volume.kinetic_J = volume.gravity_J = 0;
    for (std::size_t v = 0; v < rest_m_.size(); ++v) {
      const btSoftBody::Node& node = body.m_nodes[world_.nodeOfVertex()[v]];
      const Vec3 position_m = fromBullet(node.m_x), velocity_m_s = fromBullet(node.m_v);
      if (v < state().positions_m.size()) {
        state().positions_m[v] = position_m;
        state().velocities_m_s[v] = velocity_m_s;
      }
      if (!(node.m_im > 0)) continue;
      const double mass_kg = 1 / node.m_im;
      volume.momentum_kg_m_s += mass_kg * velocity_m_s;
      volume.kinetic_J += 0.5 * mass_kg * velocity_m_s.squaredNorm();
      volume.gravity_J -= mass_kg * gravity_m_s2_.dot(position_m - rest_m_[v]);
    }
    volume.stored_J = storedEnergy_J(body, elastic_);
    // Beside the material's damping an implicit step takes energy too, and Bullet says of neither how much.
    volume.viscous_loss_J = std::numeric_limits<double>::quiet_NaN();
    volume.mass_damping_loss_J = elastic_.mass_damping_1_s > 0 ? std::numeric_limits<double>::quiet_NaN() : 0;
    volume.inverted_elements = 0;
    for (int i = 0; i < body.m_tetraScratches.size(); ++i)
      if (!(body.m_tetraScratches[i].m_J > 0)) ++volume.inverted_elements;
    pressure_.find(impulses_N_s_, step_s_, state().positions_m, volume.pressures_Pa);
  }

  double step_s_;
  ElasticSettings elastic_;
  bool implicit_;
  SubstepCount substeps_;
  Vec3 gravity_m_s2_;
  DeformableWorld world_;
  DeformableTouch touch_;
  SteppedState stepped_;
  std::vector<Vec3> rest_m_;                           ///< of the mesh
  std::vector<Vec3> impulses_N_s_;                     ///< per surface vertex: of its contacts in the step
  std::vector<Vec3> substep_impulses_N_s_;             ///< the same in the substep
  std::vector<Vec3> positions_m_;                      ///< of the surface, at the substep's end
  btAlignedObjectArray<btVector3> velocities_before_;  ///< per node: when the substep began
  btAlignedObjectArray<btVector3> element_impulses_;   ///< per node: of elasticity and damping in the substep
  ContactPressure pressure_;
  std::vector<ToolState> tools_;  ///< at the substep's end
  double critical_step_s_ = 0, balance_s_ = 0;
};

}  // namespace

std::unique_ptr<Simulation> makeDeformableSimulation(const Scenario& scenario,
                                                     const PipelineSettings& settings, const Scene& scene,
                                                     const std::vector<Pose>& first_poses) {
  if (!settings.usesVolume())
    throw std::invalid_argument("pipeline " + std::string(settings.traits().name) +
                                " has no contact in Bullet's deformable world");
  return std::make_unique<DeformableSimulation>(scenario, settings, scene, first_poses);
}

}  // namespace fissure
