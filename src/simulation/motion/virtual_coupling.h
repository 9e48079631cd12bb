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

  const Vec3& target_m() const { return target_m_; }
  /// Of spring and damper on the tool at the end of the step; on the hand it is the opposite.
  const Vec3& force_on_tool_N() const { return force_N_; }

 private:
  CouplingSettings settings_;
  double step_s_;
  Vec3 target_m_, position_m_;
  Vec3 velocity_m_s_ = Vec3::Zero();
  Vec3 force_N_ = Vec3::Zero();
};

}  // namespace fissure
