#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_constraint.h"

namespace fissure {

/// Enforced displacement (contact/METHOD.md 5): Gauss-Seidel sweeps over the contacts. A contact that is
/// short of its target distance by d moves vertex j of its triangle by d im_j w_j / sum(im_i w_i^2) along its
/// normal, with the barycentric weights w and the inverse masses im (0: fixed).
class EnforcedDisplacement {
 public:
  EnforcedDisplacement(int vertex_count, int sweeps) : sweeps_(sweeps), is_touched_(vertex_count, 0) {}

  /// Moves `positions_m` in place ([vertex], scene frame). inverse_masses: [vertex] 1/kg.
  void apply(std::span<const ContactConstraint> constraints, std::span<const double> inverse_masses,
             std::span<Vec3> positions_m);

  /// Sum over the vertices of mass times displacement by the last apply() times the vertex's factor, kg m,
  /// scene frame.
  Vec3 movedMass(std::span<const double> inverse_masses, std::span<const Vec3> positions_m,
                 std::span<const double> factors) const;

  const DisplacementCounts& counts() const { return counts_; }

 private:
  int sweeps_;
  DisplacementCounts counts_;
  std::vector<std::uint8_t> is_touched_;
  std::vector<int> touched_;
  std::vector<Vec3> before_m_;  ///< positions of the touched vertices before the last apply()
};

}  // namespace fissure
