#include "motion/virtual_coupling.h"

namespace fissure {

VirtualCoupling::VirtualCoupling(const CouplingSettings& settings, const Vec3& start_m, double step_s)
    : settings_(settings), step_s_(step_s), target_m_(start_m), position_m_(start_m) {}

Vec3 VirtualCoupling::advance(const Vec3& target_m, const Vec3& force_on_tool_N) {
  const double k = settings_.stiffness_N_m, c = settings_.damping_N_s_m, m = settings_.mass_kg;
  const Vec3 before_m_s = velocity_m_s_;
  const Vec3 hand_m_s = (target_m - target_m_) / step_s_;
  const Vec3 pushes_N = k * (target_m - position_m_) + c * hand_m_s + force_on_tool_N;
  velocity_m_s_ = (m * velocity_m_s_ + step_s_ * pushes_N) / (m + step_s_ * c + step_s_ * step_s_ * k);
  position_m_ += step_s_ * velocity_m_s_;
  target_m_ = target_m;
  // What spring and damper say too, but without the difference of two places that a stiff spring makes equal.
  force_N_ = m * (velocity_m_s_ - before_m_s) / step_s_ - force_on_tool_N;
  return position_m_;
}

double VirtualCoupling::inverseMass_1_kg() const {
  const double k = settings_.stiffness_N_m, c = settings_.damping_N_s_m, m = settings_.mass_kg;
  return 1 / (m + step_s_ * c + step_s_ * step_s_ * k);
}

void VirtualCoupling::push(const Vec3& position_m, const Vec3& velocity_m_s) {
  force_N_ -= (settings_.damping_N_s_m + step_s_ * settings_.stiffness_N_m) * (velocity_m_s - velocity_m_s_);
  position_m_ = position_m;
  velocity_m_s_ = velocity_m_s;
}

}  // namespace fissure
