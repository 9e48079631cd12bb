#include "scenario/script.h"

namespace fissure {

std::optional<double> ScriptMotion::knownDuration_s() const {
  double duration_s = 0;
  Vec3 from = start_m;
  for (const MotionSegment& segment : segments) {
    const Vec3 to = segment.move_to_m.value_or(from);
    if (segment.hold_s) {
      duration_s += *segment.hold_s;
    } else if (segment.duration_s) {
      duration_s += *segment.duration_s;
    } else {
      duration_s += (to - from).norm() / segment.speed_m_s.value();
    }
    from = to;
  }
  return duration_s;
}

}  // namespace fissure
