#pragma once

#include <span>

#include "base/geometry.h"
#include "base/state.h"

namespace fissure {

/// A tool that is a body of its own mass: what contacts push moves it as it moves tissue. It does not turn.
struct ToolBody {
  double inverse_mass_1_kg = 0;  ///< 0: the tool goes where it is led, whatever it meets
  Vec3 offset_m = Vec3::Zero();  ///< from its pose at the step's end to where contacts moved it
  Vec3 motion_m = Vec3::Zero();  ///< the same as far as it is motion: over the step, change of its velocity
};

/// One time step as the contact stage sees it: where tissue and tools were when it began, and where they are
/// at its end. Scene frame; a view, which owns nothing. Name the fields where one is made.
struct StepView {
  /// Of all vertices at the step's end, as the engine's own solve predicts them. Detectors read them; what
  /// displaces tissue moves them in place.
  std::span<Vec3> positions_m;
  std::span<const Vec3> before_m;  ///< of the same vertices when the step began, as the last step left them
  std::span<const ToolState> tools_before;  ///< one per tool, when the step began
  std::span<const ToolState> tools_now;     ///< the same tools at the step's end
  /// The same tools as bodies, at the step's end before contacts move them; empty: all are led.
  /// ContactImpulses begins anew with their offset and motion.
  std::span<ToolBody> tool_bodies = {};
  double dt_s = 0;  ///< length of the step
};

/// Where contacts so far have moved a tool to: its pose at the step's end.
inline Pose movedPose(const StepView& step, int tool) {
  Pose pose = step.tools_now[tool].pose;
  if (!step.tool_bodies.empty()) pose.position_m += step.tool_bodies[tool].offset_m;
  return pose;
}

/// To what an engine in single precision will make of it.
inline void roundToSingle(Vec3& point_m) {
  point_m = point_m.cast<float>().cast<double>();
}

}  // namespace fissure
