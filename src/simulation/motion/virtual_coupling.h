#pragma once

#include "base/geometry.h"
#include "scenario/tools.h"

namespace fissure {

/// Virtual coupling (Colgate, Stanley and Brown, IROS 1995): a tool of mass m hangs on the hand's position by
/// a spring and a damper, m a = k (target - x) + c (target' - x') + F. Spring and damper are integrated by
/// implicit Euler, which is stable for every stiffness; F is the force at the end of the step before. The
/// tool has the orientation of the hand.
class VirtualCoupling {
 public:
  /// The tool is at rest at `start_m`, scene frame. step_s: time step, > 0.
  VirtualCoupling(const CouplingSettings& settings, const Vec3& start_m, double step_s);

  /// One step, in which the hand moves to `target_m`, scene frame. force_on_tool_N: all other force on the
  /// tool. Returns the tool's position at the end of the step, scene frame.
  Vec3 advance(const Vec3& target_m, const Vec3& force_on_tool_N);

  /// For contacts that push the tool after advance(), in the same step: the inverse of its effective mass,
  /// 1/kg. That mass is larger than the tool's own, because spring and damper resist the new velocity at
  /// once.
  double inverseMass_1_kg() const;
  /// Sets the tool's position and velocity at the end of the step, scene frame, after contacts have pushed
  /// it.
  void push(const Vec3& position_m, const Vec3& velocity_m_s);

  /// Between two steps: the hand moves `factor` times as fast from here on; where that is slower, so does the
  /// tool.
  void changeTempo(double factor) {
    if (factor < 1) velocity_m_s_ *= factor;
  }

  const Vec3& target_m() const { return target_m_; }
  /// Force of spring and damper on the tool at the end of the step, scene frame; the hand bears the opposite.
  /// Together with the contacts' force, times the step, it is the change of the tool's momentum.
  const Vec3& force_on_tool_N() const { return force_N_; }

 private:
  CouplingSettings settings_;
  double step_s_;
  Vec3 target_m_, position_m_;
  Vec3 velocity_m_s_ = Vec3::Zero();
  Vec3 force_N_ = Vec3::Zero();
};

}  // namespace fissure
