#pragma once

#include <span>

#include "base/geometry.h"
#include "base/state.h"

namespace fissure {

/// A tool with a mass, which contacts push as they push the tissue. It does not turn.
struct ToolBody {
  double inverse_mass_1_kg = 0;  ///< 0: contacts do not move the tool
  Vec3 offset_m = Vec3::Zero();  ///< displacement by contacts from its pose at the step's end, scene frame
  /// The part of it that is motion; over the step it is the change of its velocity.
  Vec3 motion_m = Vec3::Zero();
};

/// One time step, the input of the contact stage: tissue positions and tool poses at its start and its end,
/// in the scene frame. A view that owns nothing.
struct StepView {
  /// [vertex] positions at the step's end, as the engine's own solve predicts them. Detectors read them;
  /// responses move them in place.
  std::span<Vec3> positions_m;
  std::span<const Vec3> before_m;           ///< [vertex] positions when the step began
  std::span<const ToolState> tools_before;  ///< [tool] when the step began
  std::span<const ToolState> tools_now;     ///< [tool] at the step's end
  /// [tool] masses and displacements of tools that contacts can push; empty: there are none. ContactImpulses
  /// resets offset and motion.
  std::span<ToolBody> tool_bodies = {};
  double dt_s = 0;  ///< length of the step
};

/// Pose of a tool at the step's end, with its displacement by contacts so far.
inline Pose movedPose(const StepView& step, int tool) {
  Pose pose = step.tools_now[tool].pose;
  if (!step.tool_bodies.empty()) pose.position_m += step.tool_bodies[tool].offset_m;
  return pose;
}

/// Rounds a point to single precision.
inline void roundToSingle(Vec3& point_m) {
  point_m = point_m.cast<float>().cast<double>();
}

}  // namespace fissure
