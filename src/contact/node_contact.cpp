#include "contact/node_contact.h"

#include <algorithm>
#include <cmath>

namespace fissure {

namespace {

double extentOf(const TriangleMesh& mesh) {
  Vec3 low = mesh.vertices_m.front(), high = low;
  for (const Vec3& v : mesh.vertices_m) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

/// 0: leads into the tissue, 1: at rest, 2: trails. A way below 1 nm in a step is rest.
int leadingClass(const NodeCandidate& candidate) {
  constexpr double kRest_m = 1e-9;
  if (candidate.approach_m > kRest_m) return 0;
  return candidate.approach_m < -kRest_m ? 2 : 1;
}

}  // namespace

NodeContact::NodeContact(const Scene& scene, NodeContactSettings settings) : settings_(std::move(settings)) {
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const SceneTool& tool = scene.tools[t];
    for (int i = 0; i < tool.nodes.size(); ++i) {
      const int partner = tool.nodes.partners[i];
      nodes_.push_back({.tool = static_cast<int>(t),
                        .position_m = tool.nodes.positions_m[i],
                        .normal = tool.nodes.normals[i],
                        .partner = partner < 0 ? -1 : partner + tool.first_node,
                        .thickness_m = tool.nodes.thicknesses_m[i]});
    }
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    bodies_.push_back({.tree = FaceTree(body.rest.vertices_m, body.rest.faces),
                       .faces = body.rest.faces,
                       .first_vertex = body.first_vertex,
                       .first_face = body.first_face,
                       .vertex_count = static_cast<int>(body.rest.vertices_m.size()),
                       .extent_m = extentOf(body.rest),
                       .margin_m = settings_.margins_m.at(b),
                       .candidate_of_node = std::vector<int>(nodes_.size(), -1),
                       .held_since = std::vector<std::int64_t>(nodes_.size(), kNotHeld)});
  }
  is_touched_.assign(scene.vertexCount(), 0);
  for (const SceneBody& body : scene.bodies) {
    before_step_m_.insert(before_step_m_.end(), body.rest.vertices_m.begin(), body.rest.vertices_m.end());
  }
}

void NodeContact::step(std::span<Vec3> positions_m, std::span<const double> inverse_masses,
                       const std::vector<ToolState>& tools_before, const std::vector<ToolState>& tools_now,
                       double dt_s, State& state, ContactPatch& patch) {
  ++step_;
  detect(positions_m, tools_before, tools_now);
  if (settings_.association) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      std::vector<int> of_body;
      for (std::size_t c = 0; c < candidates_.size(); ++c) {
        if (candidates_[c].body == static_cast<int>(b)) of_body.push_back(static_cast<int>(c));
      }
      associate(of_body, bodies_[b]);
      remember(bodies_[b]);
    }
  }
  displace(positions_m, inverse_masses);
  report(positions_m, inverse_masses, dt_s, state, patch);
  std::copy(positions_m.begin(), positions_m.end(), before_step_m_.begin());
}

// Step one. A ray starts a margin in front of its node and runs back into the tool and out behind it; the
// first triangle of a body that it meets tells whether it started inside that body.
void NodeContact::detect(std::span<const Vec3> positions_m, const std::vector<ToolState>& tools_before,
                         const std::vector<ToolState>& tools_now) {
  candidates_.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    const auto body_positions_m = positions_m.subspan(body.first_vertex, body.vertex_count);
    body.tree.refit(body_positions_m);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Node& node = nodes_[i];
      const Pose& pose = tools_now[node.tool].pose;
      const Vec3 position_m = pose.toScene(node.position_m);
      const Vec3 travel_m = position_m - tools_before[node.tool].pose.toScene(node.position_m);
      const Vec3 normal = pose.rotateToScene(node.normal);
      node.travel_m = travel_m.norm();
      body.candidate_of_node[i] = -1;

      const Vec3 start_m = position_m + body.margin_m * normal;
      if (!body.tree.boxHolds(start_m)) continue;
      const Ray ray(start_m, -normal,
                    std::max(settings_.ray_length_m.value_or(body.extent_m), node.travel_m) + body.margin_m);
      ++rays_;
      const auto hit = body.tree.firstHit(ray, body_positions_m, ray_tests_);
      if (!hit || hit->at.cosine < 0) continue;

      const Face& face = body.faces[hit->face];
      NodeCandidate candidate{.node = static_cast<int>(i),
                              .body = static_cast<int>(b),
                              .face = hit->face,
                              .vertices = {},
                              .weights = hit->at.weights,
                              .node_position_m = position_m,
                              .normal = normal,
                              .target_m = body.margin_m};
      Vec3 tissue_travel_m = Vec3::Zero();
      for (int j = 0; j < 3; ++j) {
        const int vertex = face[j] + body.first_vertex;
        candidate.vertices[j] = vertex;
        tissue_travel_m += candidate.weights[j] * (positions_m[vertex] - before_step_m_[vertex]);
      }
      candidate.depth_m = hit->at.distance_m - body.margin_m;
      candidate.approach_m = (travel_m - tissue_travel_m).dot(normal);
      body.candidate_of_node[i] = static_cast<int>(candidates_.size());
      candidates_.push_back(candidate);
    }
  }
}

// Step two. Of the two sides of a pair whose depths overlap only one can be true: the one that has held the
// contact for longer, else the one that leads into the tissue, else the shallower. Candidates are accepted in
// that order; only an accepted one excludes others, so two vetoes cannot empty both sides. Association need
// not be mutual, therefore each candidate is checked against its own partner and against every node that
// names it as partner.
void NodeContact::associate(const std::vector<int>& candidates_of_body, Body& body) {
  std::vector<int> order = candidates_of_body;
  const auto rank = [&](int c) {
    const NodeCandidate& candidate = candidates_[c];
    const std::int64_t since = body.held_since[candidate.node];
    return std::tuple(since == kNotHeld ? step_ : since, leadingClass(candidate), candidate.depth_m,
                      candidate.node);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });

  std::vector<std::uint8_t> accepted(candidates_.size(), 0), excluded(candidates_.size(), 0);
  for (const int c : order) {
    const Node& node = nodes_[candidates_[c].node];
    const int opposite = node.partner < 0 ? -1 : body.candidate_of_node[node.partner];
    const bool overlaps =
        opposite >= 0 && candidates_[c].depth_m + candidates_[opposite].depth_m > node.thickness_m;
    // The partner's side holds the tissue though it has no candidate in this very step: a ray that runs
    // through the whole tool before it leaves the tissue found that tissue's far side.
    const bool held_across = opposite < 0 && node.partner >= 0 && body.held_since[node.partner] != kNotHeld &&
                             candidates_[c].depth_m > node.thickness_m;
    if (excluded[c] || held_across || (overlaps && accepted[opposite])) {
      candidates_[c].state = NodeState::infeasible;
      continue;
    }
    accepted[c] = 1;
    if (overlaps) excluded[opposite] = 1;
  }
}

// The chosen side keeps the pair until both of its nodes are free.
void NodeContact::remember(Body& body) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int own = body.candidate_of_node[i];
    const int partner = nodes_[i].partner;
    const bool partner_free = partner < 0 || body.candidate_of_node[partner] < 0;
    std::int64_t& since = body.held_since[i];
    if (own >= 0 && candidates_[own].state == NodeState::feasible) {
      if (since == kNotHeld) since = step_;
    } else if (own >= 0 || partner_free) {
      since = kNotHeld;
    }
  }
}

// METHOD section 5: each contact short by d moves vertex j of its triangle by d im_j w_j / sum(im_i w_i^2)
// along its normal.
void NodeContact::displace(std::span<Vec3> positions_m, std::span<const double> inverse_masses) {
  for (const int vertex : touched_) is_touched_[vertex] = 0;
  touched_.clear();
  before_displacement_m_.clear();
  for (NodeCandidate& contact : candidates_) {
    if (contact.state == NodeState::infeasible) continue;
    limitDisplacement(contact);
    for (const int vertex : contact.vertices) {
      if (is_touched_[vertex]) continue;
      is_touched_[vertex] = 1;
      touched_.push_back(vertex);
      before_displacement_m_.push_back(positions_m[vertex]);
    }
  }
  for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
    for (const NodeCandidate& contact : candidates_) {
      if (contact.state == NodeState::infeasible) continue;
      Vec3 point_m = Vec3::Zero();
      double mobility = 0;
      for (int j = 0; j < 3; ++j) {
        point_m += contact.weights[j] * positions_m[contact.vertices[j]];
        mobility += inverse_masses[contact.vertices[j]] * contact.weights[j] * contact.weights[j];
      }
      const double short_by_m = contact.target_m - (point_m - contact.node_position_m).dot(contact.normal);
      if (!(short_by_m > 0) || !(mobility > 0)) continue;
      for (int j = 0; j < 3; ++j) {
        const int vertex = contact.vertices[j];
        positions_m[vertex] +=
            short_by_m * inverse_masses[vertex] * contact.weights[j] / mobility * contact.normal;
      }
    }
  }
}

// What node and tissue approached in the step is always undone; overlap beyond that (a tool that starts
// inside, an edge-on blade) only up to the limit of one step.
void NodeContact::limitDisplacement(NodeCandidate& contact) const {
  const double allowed_m = std::max(contact.approach_m, 0.0) + settings_.max_displacement_m;
  if (contact.depth_m + contact.target_m <= allowed_m) return;
  contact.target_m = allowed_m - contact.depth_m;
  contact.state = NodeState::capped;
}

void NodeContact::report(std::span<const Vec3> positions_m, std::span<const double> inverse_masses,
                         double dt_s, State& state, ContactPatch& patch) const {
  state.node_states.assign(nodes_.size(), NodeState::free);
  state.candidate_count = static_cast<int>(candidates_.size());
  state.contact_count = state.infeasible_count = state.capped_count = 0;
  patch.clear();
  for (const NodeCandidate& candidate : candidates_) {
    // With several bodies a node shows its acting contact rather than an excluded one.
    NodeState& shown = state.node_states[candidate.node];
    if (shown == NodeState::free || shown == NodeState::infeasible) shown = candidate.state;
    if (candidate.state == NodeState::infeasible) {
      ++state.infeasible_count;
      continue;
    }
    ++state.contact_count;
    if (candidate.state == NodeState::capped) ++state.capped_count;
    patch.face_normals[bodies_[candidate.body].first_face + candidate.face] += candidate.normal;
    for (int j = 0; j < 3; ++j) {
      patch.vertex_contact[candidate.vertices[j]] = 1;
      patch.vertex_normals[candidate.vertices[j]] += candidate.weights[j] * candidate.normal;
    }
  }
  Vec3 taken = Vec3::Zero();  // kg m
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    if (inverse_masses[touched_[i]] > 0) {
      taken += (positions_m[touched_[i]] - before_displacement_m_[i]) / inverse_masses[touched_[i]];
    }
  }
  state.reaction_on_tool_N = -taken / (dt_s * dt_s);
}

}  // namespace fissure
