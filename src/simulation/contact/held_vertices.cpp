#include "contact/held_vertices.h"

namespace fissure {

void HeldVertices::hold(const StepView& step, std::span<const double> inverse_masses) {
  reached_.clear();
  sides_.find(step, {}, reached_);
  for (const ContactConstraint& contact : reached_) {
    const int vertex = contact.vertices[0];
    if (held_[vertex] || !(inverse_masses[vertex] > 0)) continue;
    const Pose& pose = step.tools_now[contact.tool].pose;
    const Vec3& point_m = step.positions_m[vertex];
    const double gap_m = (point_m - contact.position_m).dot(contact.normal) - contact.target_m;
    held_[vertex] = Held{.tool = contact.tool,
                         .position_m = pose.toBody(point_m - gap_m * contact.normal),
                         .normal = pose.rotateToBody(contact.normal)};
  }
}

}  // namespace fissure
