#include "contact/contact_impulses.h"

#include <algorithm>

namespace fissure {

namespace {

void move(const ContactConstraint& contact, double push_kg_m, std::span<const double> inverse_masses,
          std::span<Vec3> of_vertices) {
  for (int j = 0; j < cornersOf(contact.weights); ++j) {
    const int vertex = contact.vertices[j];
    of_vertices[vertex] += push_kg_m * inverse_masses[vertex] * contact.weights[j] * contact.normal;
  }
}

void move(const ContactConstraint& contact, const Vec3& push_kg_m, std::span<const double> inverse_masses,
          std::span<Vec3> of_vertices) {
  for (int j = 0; j < cornersOf(contact.weights); ++j) {
    const int vertex = contact.vertices[j];
    of_vertices[vertex] += inverse_masses[vertex] * contact.weights[j] * push_kg_m;
  }
}

/// The displacement that contacts so far have given the tool of this contact; zero for a tool that they do
/// not push.
Vec3 movedBy(const Vec3* tool_moved_m) {
  return tool_moved_m ? *tool_moved_m : Vec3::Zero();
}

}  // namespace

void ContactImpulses::apply(std::span<const ContactConstraint> constraints,
                            std::span<const double> inverse_masses, const StepView& step) {
  const std::span<Vec3> positions_m = step.positions_m;
  prepare(constraints, inverse_masses, step);
  start_m_.assign(positions_m.begin(), positions_m.end());
  pushOut(constraints, inverse_masses, positions_m);
  way_m_.resize(positions_m.size());
  for (std::size_t v = 0; v < positions_m.size(); ++v) {
    way_m_[v] = start_m_[v] - step.before_m[v];
    motion_m_[v] = positions_m[v] - start_m_[v];
  }
  beginMotion(step);
  forgetOldOverlap(constraints, inverse_masses);
}

int ContactImpulses::pushing() const {
  return static_cast<int>(std::count_if(pushes_.begin(), pushes_.end(), [](const Push& push) {
    return push.kg_m > 0 && push.tool != kGround;
  }));
}

Vec3 ContactImpulses::total(std::span<const double> factors) const {
  Vec3 total = Vec3::Zero();
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    if (pushes_[i].tool == kGround) continue;
    total += pushes_[i].kg_m * factors[pushes_[i].vertex] * normals_[i];
    total += factors[pushes_[i].vertex] * pushes_[i].friction_kg_m;
  }
  return total;
}

Vec3 ContactImpulses::ofTool(int tool, std::span<const double> factors) const {
  Vec3 total = Vec3::Zero();
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    if (pushes_[i].tool != tool) continue;
    total += factors[pushes_[i].vertex] * (pushes_[i].kg_m * normals_[i] + pushes_[i].friction_kg_m);
  }
  return total;
}

double ContactImpulses::toolWork_kg_m2() const {
  double work = 0;
  for (std::size_t i = 0; i < pushes_.size(); ++i)
    work += (pushes_[i].kg_m * normals_[i] + pushes_[i].friction_kg_m).dot(pushes_[i].tool_step_m);
  return work;
}

void ContactImpulses::prepare(std::span<const ContactConstraint> constraints,
                              std::span<const double> inverse_masses, const StepView& step) {
  pushes_.assign(constraints.size(), {});
  for (ToolBody& body : step.tool_bodies) body.offset_m = body.motion_m = Vec3::Zero();
  normals_.resize(constraints.size());
  const Pose rest;  // of the ground
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const ContactConstraint& contact = constraints[i];
    Push& push = pushes_[i];
    normals_[i] = contact.normal;
    push.vertex = contact.vertices[0];
    push.tool = contact.tool;
    double most = 0;
    for (int j = 0; j < 3; ++j) {
      push.mobility += inverse_masses[contact.vertices[j]] * contact.weights[j] * contact.weights[j];
      most = std::max(most, inverse_masses[contact.vertices[j]]);
    }
    const bool of_ground = contact.tool == kGround;
    if (!of_ground && !step.tool_bodies.empty() && step.tool_bodies[contact.tool].inverse_mass_1_kg > 0) {
      push.tool_inverse_mass_1_kg = step.tool_bodies[contact.tool].inverse_mass_1_kg;
      push.tool_moved_m = &step.tool_bodies[contact.tool].offset_m;
      push.mobility += push.tool_inverse_mass_1_kg;
    }
    if (push.mobility < least_mobility_ * most) push.mobility = 0;
    const Pose& from = of_ground ? rest : step.tools_before[contact.tool].pose;
    const Pose& to = of_ground ? rest : step.tools_now[contact.tool].pose;
    const Vec3 was_at_m = from.toScene(to.toBody(contact.position_m));
    const Vec3 normal_was = from.rotateToScene(to.rotateToBody(contact.normal));
    push.tool_step_m = contact.position_m - was_at_m;
    push.tool_way_m = push.tool_step_m.dot(contact.normal);
    push.old_overlap_m = contact.target_m - (pointOf(contact, step.before_m) - was_at_m).dot(normal_was);
    if (contact.friction > 0) push.stuck_at_m = to.toScene(from.toBody(pointOf(contact, step.before_m)));
  }
}

void ContactImpulses::pushOut(std::span<const ContactConstraint> constraints,
                              std::span<const double> inverse_masses, std::span<Vec3> positions_m) {
  bool changed = !constraints.empty();
  for (int sweep = 0; changed && sweep < sweeps_; ++sweep) {
    ++counts_.sweeps;
    changed = false;
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      const ContactConstraint& contact = constraints[i];
      Push& push = pushes_[i];
      if (!(push.mobility > 0)) continue;
      const double short_by_m =
          contact.target_m - (pointOf(contact, positions_m) - contact.position_m - movedBy(push.tool_moved_m))
                                 .dot(contact.normal);
      const double change_kg_m = std::max(short_by_m / push.mobility, -push.kg_m);
      if (change_kg_m != 0) {
        ++counts_.pushes;
        changed = true;
        push.kg_m += change_kg_m;
        move(contact, change_kg_m, inverse_masses, positions_m);
        recoil(push, change_kg_m * contact.normal);
      }
      if (contact.friction > 0)
        changed |= rub(contact, push, pointOf(contact, positions_m), inverse_masses, positions_m);
    }
  }
}

// `point_m`: where the tissue point is by those of its displacements that `of_vertices` counts. What slips is
// stopped, or slowed down by as much as the push along the normal allows. Whether that changed anything.
bool ContactImpulses::rub(const ContactConstraint& contact, Push& push, const Vec3& point_m,
                          std::span<const double> inverse_masses, std::span<Vec3> of_vertices) {
  Vec3 slip_m = point_m - push.stuck_at_m - movedBy(push.tool_moved_m);
  slip_m -= slip_m.dot(contact.normal) * contact.normal;
  Vec3 friction_kg_m = push.friction_kg_m - slip_m / push.mobility;
  const double most_kg_m = contact.friction * std::max(push.kg_m, 0.0);  // rounding may leave less than none
  const double wanted_kg_m = friction_kg_m.norm();
  if (wanted_kg_m > most_kg_m) friction_kg_m *= most_kg_m / wanted_kg_m;
  const Vec3 change_kg_m = friction_kg_m - push.friction_kg_m;
  move(contact, change_kg_m, inverse_masses, of_vertices);
  recoil(push, change_kg_m);
  push.friction_kg_m = friction_kg_m;
  return change_kg_m != Vec3::Zero();
}

// Tools' displacement in the step now has their offset, and from here on it is their motion that changes.
void ContactImpulses::beginMotion(const StepView& step) {
  for (ToolBody& body : step.tool_bodies) body.motion_m = body.offset_m;
  for (Push& push : pushes_) {
    if (!push.tool_moved_m) continue;
    push.tool_step_m += *push.tool_moved_m;
    push.tool_moved_m = &step.tool_bodies[push.tool].motion_m;
  }
}

// What a push gives the tissue, its tool loses.
void ContactImpulses::recoil(const Push& push, const Vec3& push_kg_m) {
  if (push.tool_moved_m) *push.tool_moved_m -= push.tool_inverse_mass_1_kg * push_kg_m;
}

// Where a contact pushed and its tissue now leaves the tool, the part of that speed that comes from undoing
// old overlap is taken out of the motion again, and no more than the contact gave. Friction then holds, in
// the motion, what slips in the motion, by what is left of the push.
void ContactImpulses::forgetOldOverlap(std::span<const ContactConstraint> constraints,
                                       std::span<const double> inverse_masses) {
  bool changed = !constraints.empty();
  for (int sweep = 0; changed && sweep < sweeps_; ++sweep) {
    ++counts_.sweeps;
    changed = false;
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      const ContactConstraint& contact = constraints[i];
      Push& push = pushes_[i];
      if (!(push.mobility > 0)) continue;
      if (push.kg_m > 0 && push.old_overlap_m > 0) {
        const double leaves_m =
            (pointOf(contact, way_m_) + pointOf(contact, motion_m_) - movedBy(push.tool_moved_m))
                .dot(contact.normal) -
            push.tool_way_m;
        const double removed_m =
            std::min({std::max(leaves_m, 0.0), push.old_overlap_m, push.kg_m * push.mobility});
        counts_.pushes += removed_m != 0 ? 1 : 0;
        changed |= removed_m != 0;
        push.old_overlap_m -= removed_m;
        push.kg_m -= removed_m / push.mobility;
        move(contact, -removed_m / push.mobility, inverse_masses, motion_m_);
        recoil(push, -removed_m / push.mobility * contact.normal);
      }
      if (contact.friction > 0)
        changed |= rub(contact, push, pointOf(contact, start_m_) + pointOf(contact, motion_m_),
                       inverse_masses, motion_m_);
    }
  }
}

}  // namespace fissure
