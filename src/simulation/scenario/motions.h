#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/geometry.h"
#include "scenario/choice_text.h"
#include "scenario/clamps.h"
#include "scenario/device_logs.h"

namespace fissure {

/// How the way between two waypoints is spread over its time.
enum class Timing {
  constant,      ///< constant speed: the velocity jumps at both ends
  trapezoidal,   ///< constant acceleration, cruise, constant deceleration
  minimum_jerk,  ///< 10 s^3 - 15 s^4 + 6 s^5 (Flash and Hogan 1985)
};

/// One piece of a scripted motion: either `hold_s`, or `move_to_m`, `rotate_to`, an opening or several of
/// them with one of speed and duration.
struct MotionSegment {
  std::optional<Vec3> move_to_m;  ///< scene frame; default: stay
  std::optional<Quat> rotate_to;  ///< x, y, z, w; default: stay; interpolated on the shorter arc
  std::optional<double> hold_s;   ///< rest for this long, > 0
  std::optional<double>
      speed_m_s;  ///< mean speed along the way, for every timing; needs a way of some length; > 0
  std::optional<double> duration_s;  ///< instead of speed_m_s, > 0
  Timing timing = Timing::constant;
  /// Trapezoidal: share of the time spent accelerating, and again decelerating; (0, 0.5].
  double ramp_fraction = 0.25;
  std::optional<double> open_to_m;    ///< of a clamp with parallel jaws, >= 0; default: stay
  std::optional<double> open_to_deg;  ///< of one with hinged jaws, 0..max_opening_deg

  /// Where the opening goes, metres or degrees.
  std::optional<double> openTo() const { return open_to_deg ? open_to_deg : open_to_m; }

  bool operator==(const MotionSegment&) const = default;
};

/// Waypoints and holds from a start pose; after the last segment the tool stays.
struct ScriptMotion {
  static constexpr MotionText text{"script", "waypoints and holds", "scripted motion"};

  Vec3 start_m = Vec3::Zero();
  Quat start_orientation = Quat::Identity();
  std::vector<MotionSegment> segments;
  std::optional<double> start_opening_m;    ///< of a clamp with parallel jaws, >= 0; default: closed
  std::optional<double> start_opening_deg;  ///< of one with hinged jaws, 0..max_opening_deg

  /// Time from the first pose to the end of the last segment, seconds, where validate() finds nothing wrong.
  std::optional<double> knownDuration_s() const;

  bool operator==(const ScriptMotion&) const = default;
};

enum class Interpolation { linear, monotone_cubic };

/// A recorded hand motion, from a text file.
struct ReplayMotion {
  static constexpr MotionText text{"replay", "a recorded hand motion from a text file", "replayed motion"};

  std::string file;                        ///< relative to the scenario's directory
  LogLayout layout = LogLayout::rows;      ///< names of columns, and so a time column, are of layout rows
  std::optional<std::string> time_column;  ///< time zero is the first sample kept
  /// Of time_column; default: what its name says ("time_ms", "t [us]", "timeNs"), else seconds. Needed where
  /// the name hints at something else ("ticks", "t [100 ns]").
  std::optional<TimeUnit> time_unit;
  std::optional<double> rate_hz;  ///< instead of time_column: samples at this rate, > 0
  /// Beside rate_hz: whole numbers that count the samples, also those that are missing. Time zero is the
  /// first sample kept. Default: every row is one sample later than the row before it.
  std::optional<std::string> frame_column;
  std::optional<RowFilter> where;  ///< rows that count; default: all
  std::array<std::string, 3> position_columns = {"x", "y", "z"};
  LengthUnit position_unit = LengthUnit::m;
  std::optional<std::array<std::string, 4>> quaternion_columns;  ///< x, y, z, w; default: mount alone
  DeviceMapping mapping;
  double start_s = 0.0;         ///< log time, from the first row, where the replay begins, >= 0
  std::optional<double> end_s;  ///< log time where it ends; default: the last row
  Interpolation interpolation = Interpolation::linear;
  double max_gap_s = 0.25;    ///< longer gaps between rows are held, then counted; > 0
  double jump_m = 0.02;       ///< a step between two samples longer than this is counted as a jump; > 0
  double jump_speed_m_s = 2;  ///< and one that is faster as a fast step: no hand at work is; > 0
  std::optional<DeviceOpening> opening;  ///< of a clamp, which needs it

  std::optional<double> knownDuration_s() const { return std::nullopt; }  ///< only the log says
  /// Of time_column. Empty: there is none, or neither time_unit nor its name says the unit.
  std::optional<TimeUnit> timeUnit() const {
    return time_unit || !time_column ? time_unit : timeUnitIn(*time_column);
  }

  bool operator==(const ReplayMotion&) const = default;
};

/// Where a tool goes. The catalog lists the alternatives in their order.
using ToolMotion = std::variant<ScriptMotion, ReplayMotion>;

}  // namespace fissure
