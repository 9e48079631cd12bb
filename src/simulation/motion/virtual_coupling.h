#pragma once

#include "base/geometry.h"
#include "scenario/tools.h"

namespace fissure {

/// A tool of some mass on a spring and a damper to where a hand wants it (virtual coupling; Colgate, Stanley
/// and Brown, IROS 1995): m a = k (target - x) + c (target' - x') + F, by implicit Euler in spring and
/// damper, which is stable for every stiffness, with F as it was at the end of the step before. Orientation
/// is the hand's.
class VirtualCoupling {
 public:
  /// At rest at `start_m`. step_s: seconds, > 0.
  VirtualCoupling(const CouplingSettings& settings, const Vec3& start_m, double step_s);

  /// One step, in which the hand goes on to `target_m`, scene frame; where the tool then is. force_on_tool_N:
  /// what else pushes it.
  Vec3 advance(const Vec3& target_m, const Vec3& force_on_tool_N);

  /// Where contacts push the tool within the step: the inverse of the mass that they meet after advance(),
  /// which is more than the tool's own, as spring and damper hold against its new velocity at once. 1/kg.
  double inverseMass_1_kg() const;
  /// And what they made of the step: where the tool is at its end, and its velocity there.
  void push(const Vec3& position_m, const Vec3& velocity_m_s);

  const Vec3& target_m() const { return target_m_; }
  /// Of spring and damper on the tool at the end of the step; on the hand it is the opposite. Over the step
  /// it and what contacts gave make the change of the tool's momentum.
  const Vec3& force_on_tool_N() const { return force_N_; }

 private:
  CouplingSettings settings_;
  double step_s_;
  Vec3 target_m_, position_m_;
  Vec3 velocity_m_s_ = Vec3::Zero();
  Vec3 force_N_ = Vec3::Zero();
};

}  // namespace fissure
