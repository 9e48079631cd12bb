#pragma once

#include <memory>

#include "motion/motion.h"
#include "pilot/pace.h"

namespace fissure {

/// The motion of a tool in a pilot: in step i of the pilot the tool has its pose of step `pace.run_steps[i]`
/// of the run; times between are interpolated. The original motion, a script or a replay, is not changed.
class PacedMotion final : public Motion {
 public:
  /// `step_s`: the time step of run and pilot. `pace` must outlive the motion.
  PacedMotion(std::unique_ptr<Motion> motion, const Pace& pace, double step_s)
      : motion_(std::move(motion)), pace_(pace), step_s_(step_s) {}

  Pose poseAt(double time_s) const override { return motion_->poseAt(timeOfRun_s(time_s)); }
  double openingAt(double time_s) const override { return motion_->openingAt(timeOfRun_s(time_s)); }
  double duration_s() const override { return static_cast<double>(pace_.steps()) * step_s_; }
  Summary summary() const override { return motion_->summary(); }
  std::vector<std::string> notes() const override { return motion_->notes(); }

 private:
  double timeOfRun_s(double time_s) const;

  std::unique_ptr<Motion> motion_;
  const Pace& pace_;
  double step_s_;
};

}  // namespace fissure
