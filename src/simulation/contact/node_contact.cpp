#include "contact/node_contact.h"

#include <algorithm>
#include <limits>

namespace fissure {

NodeContact::NodeContact(const Scene& scene, NodeContactSettings settings)
    : settings_(std::move(settings)),
      rays_(scene, settings_.margins_m, settings_.ray_length_m),
      associations_(settings_.association ? scene.bodies.size() : 0, NodeAssociation(scene)),
      displacement_(scene.vertexCount(), settings_.sweeps),
      node_count_(scene.nodeCount()) {
  if (settings_.vertex_contacts) {
    vertex_sides_.emplace(scene, settings_.margins_m);
    rim_edges_.emplace(scene, settings_.margins_m, settings_.max_displacement_m);
  }
  if (settings_.response == ContactResponse::momentum)
    impulses_.emplace(scene.vertexCount(), settings_.sweeps);
  if (settings_.ground)
    ground_.emplace(*settings_.ground, scene, settings_.margins_m, settings_.body_frictions);
  put_inside_.assign(scene.tools.size(), 1);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::size_t vertices = scene.bodies[b].rest.vertices_m.size();
    const double scale = settings_.time_scales.empty() ? 1 : settings_.time_scales.at(b);
    force_factors_.insert(force_factors_.end(), vertices, 1 / (scale * scale));
    if (!settings_.tool_frictions.empty())
      frictions_.insert(frictions_.end(), vertices, settings_.body_frictions.at(b));
  }
}

void NodeContact::step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
                       ContactPatch& patch) {
  StageClock clock;
  detect(step, clock);
  if (settings_.vertex_contacts) noteToolsPutInside();
  collectConstraints();
  clock.lap(times_.association_s);
  if (vertex_sides_) vertex_sides_->find(step, put_inside_, constraints_);
  if (rim_edges_) rim_edges_->find(step, put_inside_, constraints_);
  if (!frictions_.empty()) setFriction();
  clock.lap(times_.vertex_contacts_s);
  if (patch.tools.size() > 1) noteDisplacements(step.positions_m);
  outcome.reaction_on_tool_N = respond(step, inverse_masses);
  if (ground_)
    outcome.ground_reaction_N = -impulses_->ofTool(kGround, force_factors_) / (step.dt_s * step.dt_s);
  shareReaction(step.dt_s, outcome.tool_reactions_N);
  outcome.tool_work_J = impulses_ ? impulses_->toolWork_kg_m2() / (step.dt_s * step.dt_s)
                                  : std::numeric_limits<double>::quiet_NaN();
  clock.lap(times_.displacement_s);
  report(outcome, patch);
  clock.lap(times_.report_s);
}

std::span<const Vec3> NodeContact::motion_m() const {
  return impulses_ ? impulses_->motion_m() : std::span<const Vec3>();
}

const DisplacementCounts& NodeContact::displacementCounts() const {
  return impulses_ ? impulses_->counts() : displacement_.counts();
}

Vec3 NodeContact::respond(const StepView& step, std::span<const double> inverse_masses) {
  const double dt_squared = step.dt_s * step.dt_s;
  if (impulses_) {
    if (ground_)
      respondOnGround(step, inverse_masses);
    else
      impulses_->apply(constraints_, inverse_masses, step);
    return -impulses_->total(force_factors_) / dt_squared;
  }
  displacement_.apply(constraints_, inverse_masses, step.positions_m);
  return -displacement_.movedMass(inverse_masses, step.positions_m, force_factors_) / dt_squared;
}

// What a response brings below the ground, from beyond its reach, gets a contact in the next one.
void NodeContact::respondOnGround(const StepView& step, std::span<const double> inverse_masses) {
  constexpr int kMostResponses = 5;
  const std::size_t of_tools = constraints_.size();
  for (ContactConstraint& contact : constraints_) ground_->makeRoomUnder(contact);
  solved_m_.assign(step.positions_m.begin(), step.positions_m.end());
  ground_->begin(step);
  bool below = true;
  for (int response = 0; below && response < kMostResponses; ++response) {
    std::copy(solved_m_.begin(), solved_m_.end(), step.positions_m.begin());
    ground_->append(constraints_);
    impulses_->apply(constraints_, inverse_masses, step);
    constraints_.resize(of_tools);
    below = ground_->findBelow(step.positions_m, inverse_masses);
  }
}

// Enforced displacement mixes at a vertex what several tools displace there: then nobody can say.
void NodeContact::shareReaction(double dt_s, std::vector<Vec3>& tool_reactions_N) const {
  const std::size_t tools = put_inside_.size();
  tool_reactions_N.resize(impulses_ && tools > 1 ? tools : 0);
  for (std::size_t t = 0; t < tool_reactions_N.size(); ++t)
    tool_reactions_N[t] = -impulses_->ofTool(static_cast<int>(t), force_factors_) / (dt_s * dt_s);
}

void NodeContact::detect(const StepView& step, StageClock& clock) {
  candidates_.clear();
  for (int body = 0; body < rays_.bodyCount(); ++body) {
    const std::size_t first = candidates_.size();
    rays_.cast(body, step, candidates_);
    clock.lap(times_.rays_s);
    if (settings_.association) associations_[body].judge(std::span(candidates_).subspan(first));
    clock.lap(times_.association_s);
  }
}

// Such a tool has tissue on sides through which it must be dragged: what holds vertices and edges there works
// against the nodes, which push the tool out at another, and the sweeps would throw the tissue far away.
void NodeContact::noteToolsPutInside() {
  for (std::size_t tool = 0; tool < put_inside_.size(); ++tool) {
    if (!put_inside_[tool]) continue;
    put_inside_[tool] = std::any_of(candidates_.begin(), candidates_.end(), [&](const NodeCandidate& c) {
      const bool acts = c.state != NodeState::infeasible && c.constraint.tool == static_cast<int>(tool);
      return acts && (!first_step_ || c.depth_m - c.approach_m > c.constraint.target_m);
    });
  }
  first_step_ = false;
}

void NodeContact::collectConstraints() {
  constraints_.clear();
  for (NodeCandidate& candidate : candidates_) {
    if (candidate.state == NodeState::infeasible) continue;
    limitDisplacement(candidate);
    constraints_.push_back(candidate.constraint);
  }
  node_constraints_ = constraints_.size();
}

// What node and tissue approached in the step is always undone; overlap beyond that (a tool that starts
// inside, an edge-on blade) only up to the limit of one step.
void NodeContact::limitDisplacement(NodeCandidate& candidate) const {
  const double allowed_m = std::max(candidate.approach_m, 0.0) + settings_.max_displacement_m;
  if (candidate.depth_m + candidate.constraint.target_m <= allowed_m) return;
  candidate.constraint.target_m = allowed_m - candidate.depth_m;
  candidate.state = NodeState::capped;
}

void NodeContact::setFriction() {
  for (ContactConstraint& contact : constraints_)
    contact.friction = frictions_[contact.vertices[0]] * settings_.tool_frictions[contact.tool];
}

void NodeContact::noteDisplacements(std::span<const Vec3> positions_m) {
  displacements_m_.clear();
  for (const ContactConstraint& contact : constraints_) {
    const double gap_m = (pointOf(contact, positions_m) - contact.position_m).dot(contact.normal);
    displacements_m_.push_back(std::max(contact.target_m - gap_m, 0.0));
  }
}

void NodeContact::report(ContactOutcome& outcome, ContactPatch& patch) const {
  outcome.node_states.assign(node_count_, NodeState::free);
  outcome.candidate_count = static_cast<int>(candidates_.size());
  outcome.contact_count = static_cast<int>(constraints_.size());
  outcome.infeasible_count = static_cast<int>(candidates_.size() - node_constraints_);
  outcome.capped_count = 0;
  patch.clear();
  std::size_t acting = 0;
  const auto displacement_m = [&](std::size_t contact) {
    return displacements_m_.empty() ? 0.0 : displacements_m_[contact];
  };
  for (const NodeCandidate& candidate : candidates_) {
    // With several bodies a node shows its acting contact rather than an excluded one.
    NodeState& shown = outcome.node_states[candidate.node];
    if (shown == NodeState::free || shown == NodeState::infeasible) shown = candidate.state;
    if (candidate.state == NodeState::infeasible) continue;
    if (candidate.state == NodeState::capped) ++outcome.capped_count;
    patch.touchFace(candidate.constraint.tool, rays_.firstFace(candidate.body) + candidate.face,
                    candidate.constraint.normal, displacement_m(acting++));
  }
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const ContactConstraint& contact = constraints_[c];
    for (int j = 0; j < 3; ++j)
      patch.touchVertex(contact.tool, contact.vertices[j], contact.weights[j], contact.normal,
                        displacement_m(c));
  }
}

}  // namespace fissure
