#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"

namespace fissure {

/// Feasibility by node association (contact/METHOD.md 4). A thin tool deep in tissue has candidates on both
/// faces; of two partners whose depths together exceed the thickness only one can be true. One object belongs
/// to one body and one run: it remembers which side of each pair holds the contact, and since when.
class NodeAssociation {
 public:
  explicit NodeAssociation(const Scene& scene);

  /// Sets the state of the infeasible ones among this body's candidates in this step, and remembers the
  /// others.
  void judge(std::span<NodeCandidate> candidates);

 private:
  static constexpr std::int64_t kNotHeld = -1;

  void exclude(std::span<NodeCandidate> candidates);
  void remember(std::span<const NodeCandidate> candidates);

  std::vector<int> partners_;  ///< [node] index over all tools; -1: none
  std::vector<double> thicknesses_m_;
  /// [node] the step since which its side holds the contact; kNotHeld.
  std::vector<std::int64_t> held_since_;
  std::int64_t step_ = 0;

  // Working arrays of one step, members only to avoid allocations.
  std::vector<int> candidate_of_node_;  ///< -1: none
  std::vector<int> order_;
  std::vector<std::uint8_t> accepted_, excluded_;  ///< one per candidate
};

}  // namespace fissure
