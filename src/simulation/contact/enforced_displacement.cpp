#include "contact/enforced_displacement.h"

namespace fissure {

void EnforcedDisplacement::apply(std::span<const ContactConstraint> constraints,
                                 std::span<const double> inverse_masses, std::span<Vec3> positions_m) {
  for (const int vertex : touched_) is_touched_[vertex] = 0;
  touched_.clear();
  before_m_.clear();
  for (const ContactConstraint& contact : constraints) {
    for (const int vertex : contact.vertices) {
      if (is_touched_[vertex]) continue;
      is_touched_[vertex] = 1;
      touched_.push_back(vertex);
      before_m_.push_back(positions_m[vertex]);
    }
  }
  for (int sweep = 0; sweep < sweeps_; ++sweep) {
    counts_.sweeps += constraints.empty() ? 0 : 1;
    for (const ContactConstraint& contact : constraints) {
      double mobility = 0;
      for (int j = 0; j < 3; ++j)
        mobility += inverse_masses[contact.vertices[j]] * contact.weights[j] * contact.weights[j];
      const double short_by_m =
          contact.target_m - (pointOf(contact, positions_m) - contact.position_m).dot(contact.normal);
      if (!(short_by_m > 0) || !(mobility > 0)) continue;
      ++counts_.pushes;
      for (int j = 0; j < 3; ++j) {
        const int vertex = contact.vertices[j];
        positions_m[vertex] +=
            short_by_m * inverse_masses[vertex] * contact.weights[j] / mobility * contact.normal;
      }
    }
  }
}

Vec3 EnforcedDisplacement::movedMass(std::span<const double> inverse_masses,
                                     std::span<const Vec3> positions_m,
                                     std::span<const double> factors) const {
  Vec3 moved = Vec3::Zero();
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    const int vertex = touched_[i];
    if (inverse_masses[vertex] > 0)
      moved += factors[vertex] * (positions_m[vertex] - before_m_[i]) / inverse_masses[vertex];
  }
  return moved;
}

}  // namespace fissure
