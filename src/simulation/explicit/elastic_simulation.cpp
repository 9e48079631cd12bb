#include "explicit/elastic_simulation.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "stepping/contact_method.h"
#include "stepping/contact_pressure.h"
#include "stepping/elastic_model.h"
#include "stepping/stepped_state.h"
#include "stepping/tool_between.h"

namespace fissure {

namespace {

/// Means of the forces and the sum of the work of a step's substeps; the rest is the last one's.
class MeanOutcome {
 public:
  void begin() { count_ = 0; }

  void add(const ContactOutcome& outcome) {
    if (count_++ == 0) {
      sum_ = outcome;
      return;
    }
    const Vec3 reaction_N = sum_.reaction_on_tool_N + outcome.reaction_on_tool_N;
    const double work_J = sum_.tool_work_J + outcome.tool_work_J;
    std::swap(tool_reactions_N_, sum_.tool_reactions_N);
    std::optional<Vec3> ground_N = outcome.ground_reaction_N;
    if (ground_N) *ground_N += sum_.ground_reaction_N.value_or(Vec3::Zero());
    sum_ = outcome;
    sum_.reaction_on_tool_N = reaction_N;
    sum_.tool_work_J = work_J;
    sum_.ground_reaction_N = ground_N;
    for (std::size_t t = 0; t < sum_.tool_reactions_N.size(); ++t)
      sum_.tool_reactions_N[t] += tool_reactions_N_[t];
  }

  /// Into `outcome`, which keeps its own storage.
  void finish(ContactOutcome& outcome) {
    sum_.reaction_on_tool_N /= count_;
    for (Vec3& force_N : sum_.tool_reactions_N) force_N /= count_;
    if (sum_.ground_reaction_N) *sum_.ground_reaction_N /= count_;
    outcome = sum_;
  }

 private:
  ContactOutcome sum_;
  std::vector<Vec3> tool_reactions_N_;
  int count_ = 0;
};

class ElasticSimulation final : public Simulation {
 public:
  ElasticSimulation(const Scenario& scenario, const PipelineSettings& settings, const Scene& scene,
                    const std::vector<Pose>& first_poses)
      : step_s_(scenario.time.step_s),
        surface_vertices_(scene.vertexCount()),
        tissue_(makeTissue(scenario.bodies.at(0), scene.bodies.at(0), scenario.world.gravity_m_s2)),
        method_(makeContactMethod(
            {.scenario = scenario, .settings = settings, .scene = scene, .precision = Precision::f64})),
        stepped_(scenario, scene, first_poses, surfaceMasses()),
        before_m_(surface_vertices_),
        still_m_(surface_vertices_, Vec3::Zero()),
        impulses_N_s_(surface_vertices_, Vec3::Zero()),
        pressure_(scene.bodies[0].rest.faces),
        tools_from_(first_poses.size()),
        tools_to_(first_poses.size()),
        pushed_m_s_(first_poses.size()) {
    state().volume.emplace();
    collect(0);
  }

  using Simulation::step;
  void step(const std::vector<Pose>& poses, std::span<const double> tool_inverse_masses_1_kg) override {
    if (!tool_inverse_masses_1_kg.empty() && !method_->pushesTools())
      throw std::invalid_argument("the contacts of this pipeline can push no tool");
    stepped_.beginStep(poses, tool_inverse_masses_1_kg);
    StageClock clock;
    const int substeps = tissue_.substepsFor(step_s_);
    clock.lap(critical_step_s_);
    state().timing.collision_us = 0;
    mean_.begin();
    std::fill(impulses_N_s_.begin(), impulses_N_s_.end(), Vec3::Zero());
    tools_from_ = stepped_.toolsBefore();
    std::fill(pushed_m_s_.begin(), pushed_m_s_.end(), Vec3::Zero());
    for (int i = 1; i <= substeps; ++i) substep(static_cast<double>(i) / substeps, step_s_ / substeps);
    for (std::size_t t = 0; t < pushed_m_s_.size(); ++t) {
      if (!isPushed(t)) continue;
      state().tools[t].pose.position_m = tools_from_[t].pose.position_m;
      state().tools[t].velocity_m_s += pushed_m_s_[t];
    }
    mean_.finish(state().contact);
    state().volume->tool_work_J += state().contact.tool_work_J;
    collect(substeps);
    stepped_.endStep();
  }

  void changeTempo(double factor) override {
    tissue_.changeTempo(factor);
    if (factor >= 1) return;
    for (Vec3& velocity_m_s : tissue_.velocities_m_s()) velocity_m_s *= factor;
  }

  State& state() override { return stepped_.state(); }
  const State& state() const override { return stepped_.state(); }

  Summary counters() const override {
    Summary counters = method_->counters();
    counters.push_back({"substeps", substeps_});
    return counters;
  }

  std::vector<StageTime> stageTimes() const override {
    std::vector<StageTime> stages = {{"critical_step", critical_step_s_}, {"elements", elements_s_}};
    for (StageTime& stage : method_->stageTimes()) stages.push_back(std::move(stage));
    stepped_.addStageTimes(stages);
    return stages;
  }

 private:
  std::vector<double> surfaceMasses() const {
    const std::span<const double> masses_kg = tissue_.masses_kg(), inverse = tissue_.inverseMasses_1_kg();
    std::vector<double> surface_kg(surface_vertices_);
    for (std::size_t v = 0; v < surface_kg.size(); ++v) surface_kg[v] = inverse[v] > 0 ? masses_kg[v] : 0;
    return surface_kg;
  }

  bool isPushed(std::size_t tool) {
    return !stepped_.toolBodies().empty() && stepped_.toolBodies()[tool].inverse_mass_1_kg > 0;
  }

  /// Sets tools_to_, before this substep's contacts. What leads a tool that contacts push changes its
  /// velocity evenly over the step, so that at rest contacts bear the same force in every substep.
  void leadTools(double share, double substep_s) {
    const std::vector<ToolState>&before = stepped_.toolsBefore(), &now = state().tools;
    for (std::size_t t = 0; t < now.size(); ++t) {
      tools_to_[t] = share < 1 ? between(before[t], now[t], share) : now[t];
      if (!isPushed(t)) continue;
      const Vec3 &from_m_s = before[t].velocity_m_s, &to_m_s = now[t].velocity_m_s;
      tools_to_[t].velocity_m_s = from_m_s + share * (to_m_s - from_m_s) + pushed_m_s_[t];
      tools_to_[t].pose.position_m = tools_from_[t].pose.position_m + substep_s * tools_to_[t].velocity_m_s;
    }
  }

  void substep(double share, double substep_s) {
    StageClock clock;
    const std::span<Vec3> surface_m = tissue_.positions_m().first(surface_vertices_);
    std::copy(surface_m.begin(), surface_m.end(), before_m_.begin());
    tissue_.advance(substep_s);
    clock.lap(elements_s_);
    double contact_s = 0;
    leadTools(share, substep_s);
    method_->step({.positions_m = surface_m,
                   .before_m = before_m_,
                   .tools_before = tools_from_,
                   .tools_now = tools_to_,
                   .tool_bodies = stepped_.toolBodies(),
                   .dt_s = substep_s},
                  tissue_.inverseMasses_1_kg().first(surface_vertices_), outcome_, stepped_.patch());
    const std::span<const Vec3> motion_m = method_->motion_m();
    tissue_.addMotion(motion_m.empty() ? still_m_ : motion_m, substep_s);
    for (std::size_t v = 0; v < motion_m.size(); ++v)
      if (surface_kg_[v] > 0) impulses_N_s_[v] += surface_kg_[v] / substep_s * motion_m[v];
    for (std::size_t t = 0; t < pushed_m_s_.size(); ++t) {
      if (!isPushed(t)) continue;
      tools_to_[t].pose.position_m += stepped_.toolBodies()[t].offset_m;
      pushed_m_s_[t] += stepped_.toolBodies()[t].motion_m / substep_s;
    }
    std::swap(tools_from_, tools_to_);
    mean_.add(outcome_);
    clock.lap(contact_s);
    state().timing.collision_us += 1e6 * contact_s;
    ++substeps_;
  }

  void collect(int substeps) {
    const std::span<const Vec3> positions_m = std::as_const(tissue_).positions_m();
    const std::span<const Vec3> velocities_m_s = std::as_const(tissue_).velocities_m_s();
    std::copy_n(positions_m.begin(), surface_vertices_, state().positions_m.begin());
    std::copy_n(velocities_m_s.begin(), surface_vertices_, state().velocities_m_s.begin());
    const ElasticEnergies energies = tissue_.energies();
    VolumeState& volume = *state().volume;
    volume = VolumeState{.kinetic_J = energies.kinetic_J,
                         .stored_J = energies.stored_J,
                         .gravity_J = energies.gravity_J,
                         .viscous_loss_J = energies.viscous_loss_J,
                         .mass_damping_loss_J = energies.mass_damping_loss_J,
                         .contact_work_J = energies.contact_work_J,
                         .tool_work_J = volume.tool_work_J,
                         .pressures_Pa = std::move(volume.pressures_Pa),
                         .substeps = substeps,
                         .inverted_elements = tissue_.invertedElements()};
    const std::span<const double> masses_kg = tissue_.masses_kg();
    for (std::size_t v = 0; v < masses_kg.size(); ++v)
      volume.momentum_kg_m_s += masses_kg[v] * velocities_m_s[v];
    pressure_.find(impulses_N_s_, step_s_, state().positions_m, volume.pressures_Pa);
  }

  double step_s_;
  std::size_t surface_vertices_;
  ElasticTissue tissue_;
  std::unique_ptr<ContactMethod> method_;
  SteppedState stepped_;
  MeanOutcome mean_;
  ContactOutcome outcome_;      ///< of a substep
  std::vector<Vec3> before_m_;  ///< the surface when the substep began
  std::vector<Vec3> still_m_;   ///< zero per surface vertex
  std::vector<double> surface_kg_ = surfaceMasses();
  std::vector<Vec3> impulses_N_s_;  ///< per surface vertex: of its contacts in the step
  ContactPressure pressure_;
  std::vector<ToolState> tools_from_, tools_to_;
  std::vector<Vec3> pushed_m_s_;  ///< one per tool: change of its velocity by contacts in the step
  long long substeps_ = 0;
  double critical_step_s_ = 0, elements_s_ = 0;
};

}  // namespace

std::unique_ptr<Simulation> makeElasticSimulation(const Scenario& scenario, const PipelineSettings& pipeline,
                                                  const Scene& scene, const std::vector<Pose>& first_poses) {
  return std::make_unique<ElasticSimulation>(scenario, pipeline, scene, first_poses);
}

std::string elasticEngineVersion() {
  return "explicit finite elements, double precision";
}

}  // namespace fissure
