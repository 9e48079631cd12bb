#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/geometry.h"

namespace fissure {

enum class TimeUnit { s, ms, us, ns };

/// How many seconds one `unit` is.
constexpr double seconds(TimeUnit unit) {
  constexpr std::array<double, 4> sizes = {1, 1e-3, 1e-6, 1e-9};
  return sizes[static_cast<std::size_t>(unit)];
}

/// The unit of time that a column's name says, in any case: "time_ms", "t [us]", "Time [ms] since start",
/// "elapsed/s", "timeMs", "TIMEMS", "milliseconds"; seconds where it says none. Empty where it hints at
/// something else: two units ("ns_to_ms"), a number of one ("t [100 ns]"), another one ("ticks"), another
/// word in brackets.
std::optional<TimeUnit> timeUnitIn(std::string_view column);

/// Which rows of a log count.
struct RowFilter {
  std::string column;
  std::string equals;  ///< the whole cell of such a row, without quotes and the blanks around it

  bool operator==(const RowFilter&) const = default;
};

/// How a log's axes lie.
enum class DeviceFrame {
  scene,   ///< as DeviceMapping::axes says
  novint,  ///< Falcon by its own driver: x right, y up, z to the operator, as the scene's
  chai3d,  ///< Falcon by CHAI3D: x to the operator, y right, z up
};

/// How a log's text is laid out.
enum class LogLayout {
  rows,  ///< a header line of names, then one line a sample
  axes,  ///< no header: one line of all x, one of all y, one of all z
};

/// From the log's device frame to the scene:
///   position = origin_scene_m + scale * R * (p_device - origin_device_m)
///   orientation = R * q_device * mount
/// R maps device axes to scene axes: row i of `axes` names the device axis ("x", "-y", ...) that scene axis i
/// is.
struct DeviceMapping {
  std::array<std::string, 3> axes = {"x", "y", "z"};  ///< must form a right-handed frame; frame scene only
  double scale = 1.0;                                 ///< > 0
  /// Shown at origin_scene_m. What the driver adds to a coordinate is part of it: a Falcon's z (novint), x
  /// (chai3d) is counted from a point 0.110, 0.125 or 0.150 m off, depending on the driver.
  Vec3 origin_device_m = Vec3::Zero();
  Vec3 origin_scene_m = Vec3::Zero();
  Quat mount = Quat::Identity();  ///< the tool in the hand: x, y, z, w
  DeviceFrame frame = DeviceFrame::scene;

  /// Row i: the device axis that scene axis i is.
  std::array<std::string, 3> sceneAxes() const {
    if (frame == DeviceFrame::novint) return {"x", "y", "z"};
    if (frame == DeviceFrame::chai3d) return {"y", "z", "x"};
    return axes;
  }

  bool operator==(const DeviceMapping&) const = default;
};

}  // namespace fissure
