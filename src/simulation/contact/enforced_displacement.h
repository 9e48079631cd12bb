#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_constraint.h"

namespace fissure {

/// Feasible enforced displacement (METHOD section 5): Gauss-Seidel sweeps over the contacts; one short by d
/// moves vertex j of its triangle by d im_j w_j / sum(im_i w_i^2) along its normal (w: weights, im: inverse
/// masses, 0: fixed).
class EnforcedDisplacement {
 public:
  EnforcedDisplacement(int vertex_count, int sweeps) : sweeps_(sweeps), is_touched_(vertex_count, 0) {}

  /// Moves `positions_m` in place.
  void apply(std::span<const ContactConstraint> constraints, std::span<const double> inverse_masses,
             std::span<Vec3> positions_m);

  /// Sum of mass times displacement of the last apply, kg m; each vertex' times its factor.
  Vec3 movedMass(std::span<const double> inverse_masses, std::span<const Vec3> positions_m,
                 std::span<const double> factors) const;

  const DisplacementCounts& counts() const { return counts_; }

 private:
  int sweeps_;
  DisplacementCounts counts_;
  std::vector<std::uint8_t> is_touched_;
  std::vector<int> touched_;
  std::vector<Vec3> before_m_;  ///< of the touched vertices
};

}  // namespace fissure
