#pragma once

#include <array>
#include <optional>
#include <string>

#include "scenario/choice_text.h"
#include "scenario/clamps.h"
#include "scenario/device_logs.h"

namespace fissure {

/// Interpolation of positions between samples.
enum class Interpolation { linear, monotone_cubic };

/// A recorded hand motion, from a text file.
struct ReplayMotion {
  static constexpr MotionText text{"replay", "a recorded hand motion from a text file", "replayed motion"};

  std::string file;
  LogLayout layout = LogLayout::rows;
  std::optional<std::string> time_column;
  std::optional<TimeUnit> time_unit;
  std::optional<double> rate_hz;
  std::optional<std::string> frame_column;
  std::optional<RowFilter> where;
  std::array<std::string, 3> position_columns = {"x", "y", "z"};
  LengthUnit position_unit = LengthUnit::m;
  std::optional<std::array<std::string, 4>> quaternion_columns;
  DeviceMapping mapping;
  double start_s = 0.0;
  std::optional<double> end_s;
  Interpolation interpolation = Interpolation::linear;
  double max_gap_s = 0.25;
  double jump_m = 0.02;
  double jump_speed_m_s = 2;
  std::optional<DeviceOpening> opening;

  std::optional<double> knownDuration_s() const { return std::nullopt; }  ///< known only from the log
  /// The unit of time_column: time_unit, else the unit in its name. No value: there is no such column, or its
  /// unit is unknown.
  std::optional<TimeUnit> timeUnit() const {
    return time_unit || !time_column ? time_unit : timeUnitIn(*time_column);
  }

  bool operator==(const ReplayMotion&) const = default;
};

template <class Io>
void describe(Io& io, ReplayMotion& m) {
  io.field("file", m.file,
           Key("Log file, a text table, relative to the folder of the scenario file.").required());
  io.field("layout", m.layout, Key("How the text of the log is laid out.").oneOf(catalog().log_layouts));
  const bool rows = m.layout == LogLayout::rows;
  const char* const of_rows = "layout rows";
  io.field("time_column", m.time_column,
           Key("Column of times. Time zero of the scene is the first sample kept. Exactly one of "
               "`time_column` and `rate_hz` is given.")
               .otherwise("`rate_hz` says the times")
               .onlyIf(rows, of_rows));
  io.field(
      "time_unit", m.time_unit,
      Key("Unit of `time_column`, needed where its name hints at something else (\"ticks\", \"t [100 ns]\").")
          .oneOf(catalog().time_units)
          .otherwise("what the column's name says (\"time_ms\", \"t [us]\"), else seconds")
          .onlyIf(rows, of_rows));
  io.field("rate_hz", m.rate_hz,
           Key("Rate of the samples, instead of `time_column`.")
               .above(0)
               .otherwise("`time_column` says the times"));
  io.field("frame_column", m.frame_column,
           Key("Column of whole numbers that count the samples at `rate_hz`, also those that are missing. "
               "Time zero is the first sample kept.")
               .otherwise("every row is one sample later than the row before it")
               .onlyIf(rows, of_rows));
  io.field("where", m.where, Key("Which rows of the log count.").otherwise("all rows").onlyIf(rows, of_rows));
  io.field("position_columns", m.position_columns,
           Key("Columns of the position, in the device's order of axes.").onlyIf(rows, of_rows));
  io.field("position_unit", m.position_unit,
           Key("Unit of the positions in the log.").oneOf(catalog().length_units));
  io.field("quaternion_columns", m.quaternion_columns,
           Key("Columns of the orientation, in the order x, y, z, w; any length but zero is taken.")
               .otherwise("none: the orientation is that of `mapping.mount`")
               .onlyIf(rows, of_rows));
  io.field("mapping", m.mapping,
           Key("From the device's frame to the scene's: position = origin_scene_m + scale R (p - "
               "origin_device_m), orientation = R q mount, where R maps the device's axes to the scene's."));
  io.field("opening", m.opening,
           Key("How an axis of the device opens a clamp, linearly between two places; beyond either the "
               "opening stays, and the samples are counted.")
               .otherwise("required of a clamp, an error of other tools"));
  io.field("start_s", m.start_s,
           Key("Time of the log, counted from its first row, where the replay begins.").atLeast(0));
  io.field("end_s", m.end_s,
           Key("Time of the log, after `start_s`, where the replay ends.").otherwise("the last row"));
  io.field("interpolation", m.interpolation,
           Key("How positions between samples are found.").oneOf(catalog().interpolations));
  io.field("max_gap_s", m.max_gap_s,
           Key("In longer gaps between rows the tool holds still; they are counted.").above(0));
  io.field(
      "jump_m", m.jump_m,
      Key("Longer steps between two samples are counted as jumps; they are played as they are.").above(0));
  io.field("jump_speed_m_s", m.jump_speed_m_s,
           Key("Steps that are faster are counted as fast steps, which no hand at work makes; they are "
               "played as they are.")
               .above(0));
}

}  // namespace fissure
