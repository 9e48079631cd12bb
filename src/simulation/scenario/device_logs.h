#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/geometry.h"
#include "scenario/catalog.h"
#include "scenario/key.h"

namespace fissure {

enum class TimeUnit { s, ms, us, ns };

/// How many seconds one `unit` is.
constexpr double seconds(TimeUnit unit) {
  constexpr std::array<double, 4> sizes = {1, 1e-3, 1e-6, 1e-9};
  return sizes[static_cast<std::size_t>(unit)];
}

/// The unit of time in a column's name, in upper or lower case: "time_ms", "t [us]", "Time [ms] since start",
/// "elapsed/s", "timeMs", "TIMEMS", "milliseconds"; seconds where the name has no unit. No value where the
/// name is ambiguous: two units ("ns_to_ms"), a multiple of a unit ("t [100 ns]"), another unit ("ticks") or
/// another word in brackets.
std::optional<TimeUnit> timeUnitIn(std::string_view column);

/// A filter for the rows of a log: those in which `column` holds the text `equals` are read, all others are
/// left out.
struct RowFilter {
  std::string column;
  std::string equals;

  bool operator==(const RowFilter&) const = default;
};

/// The orientation of a log's coordinate axes.
enum class DeviceFrame {
  scene,   ///< given by DeviceMapping::axes
  novint,  ///< Falcon by its own driver: x right, y up, z towards the operator, like the scene frame
  chai3d,  ///< Falcon by CHAI3D: x towards the operator, y right, z up
};

/// The layout of a log's text.
enum class LogLayout {
  rows,  ///< a header line of column names, then one line per sample
  axes,  ///< no header: one line with all x, one with all y, one with all z
};

/// From the log's device frame to the scene:
///   position = origin_scene_m + scale * R * (p_device - origin_device_m)
///   orientation = R * q_device * mount
/// R maps device axes to scene axes: row i of `axes` names the device axis ("x", "-y", ...) that scene axis i
/// is.
struct DeviceMapping {
  std::array<std::string, 3> axes = {"x", "y", "z"};
  double scale = 1.0;
  Vec3 origin_device_m = Vec3::Zero();
  Vec3 origin_scene_m = Vec3::Zero();
  Quat mount = Quat::Identity();
  DeviceFrame frame = DeviceFrame::scene;

  /// Entry i names the device axis that is scene axis i: `axes`, or the axes of a known frame.
  std::array<std::string, 3> sceneAxes() const {
    if (frame == DeviceFrame::novint) return {"x", "y", "z"};
    if (frame == DeviceFrame::chai3d) return {"y", "z", "x"};
    return axes;
  }

  bool operator==(const DeviceMapping&) const = default;
};

template <class Io>
void describe(Io& io, RowFilter& f) {
  io.field("column", f.column, Key("Name of the column that is looked at.").required());
  io.field(
      "equals", f.equals,
      Key("Text of the whole cell of rows that count, without quotes and the blanks around it.").required());
}

template <class Io>
void describe(Io& io, DeviceMapping& m) {
  io.field("frame", m.frame, Key("How the axes of the log lie.").oneOf(catalog().device_frames));
  io.field("axes", m.axes,
           Key("For each axis of the scene the axis of the device that it is, perhaps with a minus: [x, -z, "
               "y]. They must form a right-handed frame.")
               .onlyIf(m.frame == DeviceFrame::scene, "frame scene"));
  io.field("scale", m.scale,
           Key("Displacement in the scene over displacement of the device.").noUnit().above(0));
  io.field("origin_device_m", m.origin_device_m,
           Key("Place in the device's frame that is shown at `origin_scene_m`. What the driver adds to a "
               "coordinate is part of it: a Falcon's z (novint) or x (chai3d) is counted from a point 0.110, "
               "0.125 or 0.150 m off, depending on the driver."));
  io.field("origin_scene_m", m.origin_scene_m,
           Key("Place in the scene's frame where `origin_device_m` is shown."));
  io.field(
      "mount", m.mount,
      Key("Rotation of the tool in the hand, a unit quaternion [x, y, z, w], applied before that of the log.")
          .noUnit());
}

}  // namespace fissure
