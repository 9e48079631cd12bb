#pragma once

#include <optional>
#include <vector>

#include "base/geometry.h"
#include "scenario/choice_text.h"
#include "scenario/clamps.h"

namespace fissure {

/// The velocity profile between two waypoints.
enum class Timing {
  constant,     ///< constant speed; the velocity jumps at both ends
  trapezoidal,  ///< constant acceleration, constant speed, constant deceleration
  /// Share 10 s^3 - 15 s^4 + 6 s^5 of the path at the share s of the time (Flash and Hogan 1985).
  minimum_jerk,
};

/// One segment of a scripted motion: either `hold_s`, or one or more targets (`move_to_m`, `rotate_to`, an
/// opening) with a speed or a duration.
struct MotionSegment {
  std::optional<Vec3> move_to_m;
  std::optional<Quat> rotate_to;
  std::optional<double> hold_s;
  std::optional<double> speed_m_s;
  std::optional<double> duration_s;
  Timing timing = Timing::constant;
  double ramp_fraction = 0.25;
  std::optional<double> open_to_m;
  std::optional<double> open_to_deg;

  /// The target of the opening, metres or degrees.
  std::optional<double> openTo() const { return open_to_deg ? open_to_deg : open_to_m; }

  bool operator==(const MotionSegment&) const = default;
};

/// Waypoints and holds from a start pose in the scene frame; after the last segment the tool rests.
struct ScriptMotion {
  static constexpr MotionText text{"script", "waypoints and holds", "scripted motion"};

  Vec3 start_m = Vec3::Zero();
  Quat start_orientation = Quat::Identity();
  std::vector<MotionSegment> segments;
  std::optional<double> start_opening_m;
  std::optional<double> start_opening_deg;

  /// Time from the start to the end of the last segment, seconds, for a motion without problems (validate()).
  std::optional<double> knownDuration_s() const;

  bool operator==(const ScriptMotion&) const = default;
};

template <class Io>
void describe(Io& io, MotionSegment& s) {
  const char* const one_time = "one of `speed_m_s` and `duration_s` is required where the segment moves";
  io.field("hold_s", s.hold_s,
           Key("The tool rests for this long; the segment then has no other key.")
               .above(0)
               .otherwise("the segment moves"));
  io.field("move_to_m", s.move_to_m,
           Key("Where the tool's origin goes in a straight line, in the scene's frame.")
               .otherwise("it stays where it is"));
  io.field("rotate_to", s.rotate_to,
           Key("Orientation to which the tool turns on the shorter arc, a unit quaternion [x, y, z, w].")
               .noUnit()
               .otherwise("it keeps its orientation"));
  io.field("open_to_m", s.open_to_m,
           Key("Opening to which a clamp with parallel jaws goes.")
               .atLeast(0, jaws_touch)
               .otherwise("it keeps its opening"));
  io.field("open_to_deg", s.open_to_deg,
           Key("Opening to which a clamp with hinged jaws goes.")
               .between(0, max_opening_deg)
               .otherwise("it keeps its opening"));
  io.field("speed_m_s", s.speed_m_s,
           Key("Mean speed along the path, for every timing; the path must have some length.")
               .above(0)
               .otherwise(one_time));
  io.field("duration_s", s.duration_s,
           Key("Time that the segment takes, instead of a speed.").above(0).otherwise(one_time));
  io.field("timing", s.timing,
           Key("How the motion is spread over its time.")
               .oneOf(catalog().timings)
               .onlyIf(!s.hold_s, "a segment that moves or rotates"));
  io.field("ramp_fraction", s.ramp_fraction,
           Key("Share of the time spent on accelerating, and again on decelerating.")
               .noUnit()
               .above(0, 0.5)
               .onlyIf(!s.hold_s && s.timing == Timing::trapezoidal, "timing trapezoidal"));
}

template <class Io>
void describe(Io& io, ScriptMotion& m) {
  io.field("start_m", m.start_m,
           Key("Where the tool's origin is at time zero, in the scene's frame.").required());
  io.field("start_orientation", m.start_orientation,
           Key("Orientation of the tool at time zero, a unit quaternion [x, y, z, w].").noUnit());
  io.field(
      "start_opening_m", m.start_opening_m,
      Key("Opening at time zero of a clamp with parallel jaws.").atLeast(0, jaws_touch).otherwise("closed"));
  io.field("start_opening_deg", m.start_opening_deg,
           Key("Opening at time zero of a clamp with hinged jaws.")
               .between(0, max_opening_deg)
               .otherwise("closed"));
  io.field("segments", m.segments,
           Key("What the tool does, one after the other: holds and moves. After the last one it stays."));
}

}  // namespace fissure
