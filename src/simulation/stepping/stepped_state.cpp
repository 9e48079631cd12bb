#include "stepping/stepped_state.h"

#include <utility>

#include "base/rotation.h"

namespace fissure {

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

}  // namespace

SteppedState::SteppedState(const Scenario& scenario, const Scene& scene, const std::vector<Pose>& first_poses,
                           std::vector<double> masses_kg)
    : step_s_(scenario.time.step_s) {
  const std::size_t laws = scenario.force.size(), tools = scene.tools.size();
  if (laws > 0)
    forces_ = std::make_unique<TriangleForces>(scene, makeLaws(scenario.force), step_s_,
                                               scenario.record.force_inputs);
  for (const Pose& pose : first_poses) state_.tools.push_back({.pose = pose});
  patch_.resize(scene.vertexCount(), scene.faceCount(), laws > 0 ? tools : 0);
  patch_.clear();
  state_.positions_m.resize(scene.vertexCount());
  state_.velocities_m_s.resize(scene.vertexCount());
  state_.masses_kg = std::move(masses_kg);
  state_.contact.node_states.assign(scene.nodeCount(), NodeState::free);
  state_.contact.tool_reactions_N.assign(tools > 1 ? tools : 0, Vec3::Zero());
  state_.contact.vertex_contact = patch_.vertex_contact;
  state_.forces.assign(laws, ForceSample{});
  state_.tool_forces_N.assign(laws * tools, Vec3::Zero());
}

void SteppedState::beginStep(const std::vector<Pose>& poses,
                             std::span<const double> tool_inverse_masses_1_kg) {
  bodies_.clear();
  for (const double inverse_mass_1_kg : tool_inverse_masses_1_kg)
    bodies_.push_back({.inverse_mass_1_kg = inverse_mass_1_kg});
  before_ = state_.tools;
  for (std::size_t t = 0; t < poses.size(); ++t) {
    ToolState& tool = state_.tools[t];
    const Eigen::AngleAxisd turn = axisAndAngle(poses[t].orientation * tool.pose.orientation.conjugate());
    tool.velocity_m_s = (poses[t].position_m - tool.pose.position_m) / step_s_;
    tool.angular_velocity_rad_s = turn.axis() * (turn.angle() / step_s_);
    tool.pose = poses[t];
  }
}

void SteppedState::endStep() {
  state_.contact.vertex_contact = patch_.vertex_contact;
  if (!forces_) return;
  StageClock clock;
  forces_->evaluate(patch_, state_);
  clock.lap(forces_s_);
}

void SteppedState::addStageTimes(std::vector<StageTime>& stages) const {
  if (forces_) stages.push_back({"force_laws", forces_s_});
}

}  // namespace fissure
