#include "contact/node_contact.h"

#include <algorithm>

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
  put_inside_.assign(scene.tools.size(), 1);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::vector<Vec3>& rest_m = scene.bodies[b].rest.vertices_m;
    before_m_.insert(before_m_.end(), rest_m.begin(), rest_m.end());
    const double scale = settings_.time_scales.empty() ? 1 : settings_.time_scales.at(b);
    force_factors_.insert(force_factors_.end(), rest_m.size(), 1 / (scale * scale));
    if (!settings_.tool_frictions.empty())
      frictions_.insert(frictions_.end(), rest_m.size(), settings_.body_frictions.at(b));
  }
}

void NodeContact::step(std::span<Vec3> positions_m, std::span<const double> inverse_masses,
                       const std::vector<ToolState>& tools_before, const std::vector<ToolState>& tools_now,
                       double dt_s, State& state, ContactPatch& patch) {
  StageClock clock;
  detect(positions_m, tools_before, tools_now, clock);
  if (settings_.vertex_contacts) noteToolsPutInside();
  collectConstraints();
  clock.lap(times_.association_s);
  if (vertex_sides_)
    vertex_sides_->find(positions_m, before_m_, tools_now, tools_before, put_inside_, constraints_);
  if (rim_edges_)
    rim_edges_->find(positions_m, before_m_, tools_now, tools_before, put_inside_, constraints_);
  if (!frictions_.empty()) roughen();
  clock.lap(times_.vertex_contacts_s);
  if (patch.tools.size() > 1) noteDisplacements(positions_m);
  state.reaction_on_tool_N = respond(positions_m, inverse_masses, tools_before, tools_now, dt_s);
  shareReaction(dt_s, state.tool_reactions_N);
  clock.lap(times_.displacement_s);
  report(state, patch);
  std::copy(positions_m.begin(), positions_m.end(), before_m_.begin());
  clock.lap(times_.report_s);
}

std::span<const Vec3> NodeContact::motion_m() const {
  return impulses_ ? impulses_->motion_m() : std::span<const Vec3>();
}

const DisplacementCounts& NodeContact::displacementCounts() const {
  return impulses_ ? impulses_->counts() : displacement_.counts();
}

Vec3 NodeContact::respond(std::span<Vec3> positions_m, std::span<const double> inverse_masses,
                          const std::vector<ToolState>& tools_before, const std::vector<ToolState>& tools_now,
                          double dt_s) {
  if (impulses_) {
    impulses_->apply(constraints_, inverse_masses, tools_before, tools_now, before_m_, positions_m);
    return -impulses_->total(force_factors_) / (dt_s * dt_s);
  }
  displacement_.apply(constraints_, inverse_masses, positions_m);
  return -displacement_.movedMass(inverse_masses, positions_m, force_factors_) / (dt_s * dt_s);
}

// Enforced displacement mixes at a vertex what several tools displace there: then nobody can say.
void NodeContact::shareReaction(double dt_s, std::vector<Vec3>& tool_reactions_N) const {
  const std::size_t tools = put_inside_.size();
  tool_reactions_N.resize(impulses_ && tools > 1 ? tools : 0);
  for (std::size_t t = 0; t < tool_reactions_N.size(); ++t)
    tool_reactions_N[t] =
        -impulses_->ofTool(static_cast<int>(t), constraints_, force_factors_) / (dt_s * dt_s);
}

void NodeContact::detect(std::span<const Vec3> positions_m, const std::vector<ToolState>& tools_before,
                         const std::vector<ToolState>& tools_now, StageClock& clock) {
  candidates_.clear();
  for (int body = 0; body < rays_.bodyCount(); ++body) {
    const std::size_t first = candidates_.size();
    rays_.cast(body, positions_m, before_m_, tools_now, tools_before, candidates_);
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

void NodeContact::roughen() {
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

void NodeContact::report(State& state, ContactPatch& patch) const {
  state.node_states.assign(node_count_, NodeState::free);
  state.candidate_count = static_cast<int>(candidates_.size());
  state.contact_count = static_cast<int>(constraints_.size());
  state.infeasible_count = static_cast<int>(candidates_.size() - node_constraints_);
  state.capped_count = 0;
  patch.clear();
  std::size_t acting = 0;
  const auto displacement_m = [&](std::size_t contact) {
    return displacements_m_.empty() ? 0.0 : displacements_m_[contact];
  };
  for (const NodeCandidate& candidate : candidates_) {
    // With several bodies a node shows its acting contact rather than an excluded one.
    NodeState& shown = state.node_states[candidate.node];
    if (shown == NodeState::free || shown == NodeState::infeasible) shown = candidate.state;
    if (candidate.state == NodeState::infeasible) continue;
    if (candidate.state == NodeState::capped) ++state.capped_count;
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
