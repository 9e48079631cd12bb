#include "contact/node_association.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace fissure {

namespace {

/// 0: leads into the tissue, 1: at rest, 2: trails. A way below 1 nm in a step is rest.
int leadingClass(const NodeCandidate& candidate) {
  constexpr double kRest_m = 1e-9;
  if (candidate.approach_m > kRest_m) return 0;
  return candidate.approach_m < -kRest_m ? 2 : 1;
}

}  // namespace

NodeAssociation::NodeAssociation(const Scene& scene) {
  for (const SceneTool& tool : scene.tools) {
    for (int i = 0; i < tool.nodes.size(); ++i) {
      const int partner = tool.nodes.partners[i];
      partners_.push_back(partner < 0 ? -1 : partner + tool.first_node);
      thicknesses_m_.push_back(tool.nodes.thicknesses_m[i]);
    }
  }
  held_since_.assign(partners_.size(), kNotHeld);
  candidate_of_node_.assign(partners_.size(), -1);
}

void NodeAssociation::judge(std::span<NodeCandidate> candidates) {
  ++step_;
  std::fill(candidate_of_node_.begin(), candidate_of_node_.end(), -1);
  for (std::size_t c = 0; c < candidates.size(); ++c)
    candidate_of_node_[candidates[c].node] = static_cast<int>(c);
  exclude(candidates);
  remember(candidates);
}

// Accepted in order: the side that has held the contact for longer, else the one that leads into the tissue,
// else the shallower. Only an accepted candidate excludes others, so two vetoes cannot empty both sides.
// Association need not be mutual, therefore each candidate is checked against its own partner and against
// every node that names it as partner.
void NodeAssociation::exclude(std::span<NodeCandidate> candidates) {
  const auto rank = [&](int c) {
    const NodeCandidate& candidate = candidates[c];
    const std::int64_t since = held_since_[candidate.node];
    return std::tuple(since == kNotHeld ? step_ : since, leadingClass(candidate), candidate.depth_m,
                      candidate.node);
  };
  order_.resize(candidates.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](int a, int b) { return rank(a) < rank(b); });

  accepted_.assign(candidates.size(), 0);
  excluded_.assign(candidates.size(), 0);
  for (const int c : order_) {
    NodeCandidate& candidate = candidates[c];
    const int partner = partners_[candidate.node];
    const double thickness_m = thicknesses_m_[candidate.node];
    const int opposite = partner < 0 ? -1 : candidate_of_node_[partner];
    const bool overlaps = opposite >= 0 && candidate.depth_m + candidates[opposite].depth_m > thickness_m;
    // The partner's side holds the tissue though it has no candidate in this very step: a ray that runs
    // through the whole tool before it leaves the tissue found that tissue's far side.
    const bool held_across =
        opposite < 0 && partner >= 0 && held_since_[partner] != kNotHeld && candidate.depth_m > thickness_m;
    if (excluded_[c] || held_across || (overlaps && accepted_[opposite])) {
      candidate.state = NodeState::infeasible;
      continue;
    }
    accepted_[c] = 1;
    if (overlaps) excluded_[opposite] = 1;
  }
}

// The chosen side keeps the pair until both of its nodes are free, or until it has let go of the tissue while
// the other side holds some: of a blade that turns in a slit both sides held the slit's walls at first, and
// the side that turns away must not veto the one that goes on pushing.
void NodeAssociation::remember(std::span<const NodeCandidate> candidates) {
  for (std::size_t i = 0; i < partners_.size(); ++i) {
    const int own = candidate_of_node_[i];
    const int opposite = partners_[i] < 0 ? -1 : candidate_of_node_[partners_[i]];
    const bool opposite_excluded = opposite >= 0 && candidates[opposite].state == NodeState::infeasible;
    std::int64_t& since = held_since_[i];
    if (own >= 0 && candidates[own].state != NodeState::infeasible) {
      if (since == kNotHeld) since = step_;
    } else if (own >= 0 || !opposite_excluded) {
      since = kNotHeld;
    }
  }
}

}  // namespace fissure
