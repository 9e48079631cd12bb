#pragma once

#include <span>

#include "base/geometry.h"
#include "base/state.h"

namespace fissure {

/// One time step as the contact stage sees it: where tissue and tools were when it began, and where they are
/// at its end. Scene frame; a view, which owns nothing. Name the fields where one is made.
struct StepView {
  /// Of all vertices at the step's end, as the engine's own solve predicts them. Detectors read them; what
  /// displaces tissue moves them in place.
  std::span<Vec3> positions_m;
  std::span<const Vec3> before_m;  ///< of the same vertices when the step began, as the last step left them
  std::span<const ToolState> tools_before;  ///< one per tool, when the step began
  std::span<const ToolState> tools_now;     ///< the same tools at the step's end
  double dt_s = 0;                          ///< length of the step
};

/// To what an engine in single precision will make of it.
inline void roundToSingle(Vec3& point_m) {
  point_m = point_m.cast<float>().cast<double>();
}

}  // namespace fissure
