#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/shapes.h"

namespace fissure {

/// A rigid piece of a clamp, where it is in the clamp's frame when the clamp is closed.
struct ClampPart {
  SurfaceShape shape = BoxShape{};
  Vec3 position_m = Vec3::Zero();       ///< of the shape's own origin
  Quat orientation = Quat::Identity();  ///< x, y, z, w in files
  bool mirrored = false;                ///< the shape's mirror image in its own x = 0; not in files

  bool operator==(const ClampPart&) const = default;
};

/// How the jaws of a clamp open.
enum class ClampOpening {
  parallel,  ///< they slide apart along x; the opening is the way between them, metres
  hinged,    ///< they turn about an axis along z; the opening is the angle between them, degrees
};

/// What makes a tool a clamp: two rigid jaws, which meet the tissue and not each other. Its frame: the jaws
/// lie left (x < 0) and right (x > 0) of the plane x = 0, hinged ones below their hinge; opening 0 is closed,
/// where jaws may touch. Each jaw goes half of the opening. The tool's shape is the right jaw's, and nodes,
/// friction and force limit are each jaw's.
struct ClampSettings {
  ClampOpening opening = ClampOpening::parallel;
  double hinge_height_m = 0;                ///< y of the hinge, which lies in x = 0; no default; hinged only
  Vec3 jaw_position_m = Vec3::Zero();       ///< of the right jaw's own origin, closed
  Quat jaw_orientation = Quat::Identity();  ///< x, y, z, w in files
  /// Default: the mirror image of the right jaw in the plane x = 0.
  std::optional<ClampPart> left_jaw;
  /// Drawn in frames with the clamp, and nothing else: it never meets anything.
  std::vector<ClampPart> handle;

  bool operator==(const ClampSettings&) const = default;
};

/// The largest angle between hinged jaws, degrees: each then stands square to the clamp.
constexpr double max_opening_deg = 180;

/// An axis of a haptic device, as its log has it.
enum class DeviceAxis { x, y, z };

/// How a replayed device opens a clamp: by its coordinate along one of its axes, linearly between two places.
/// That axis then does not move the clamp, which stays in the plane of the other two through origin_scene_m.
/// Beyond either place the opening stays where it is there, and the samples are counted.
struct DeviceOpening {
  DeviceAxis axis = DeviceAxis::x;
  double closed_device_m = 0;      ///< where the clamp is closed
  double open_device_m = 0;        ///< where it is open, on either side of that
  std::optional<double> open_m;    ///< the opening there, > 0: of parallel jaws
  std::optional<double> open_deg;  ///< of hinged ones, at most max_opening_deg

  /// The opening at open_device_m, metres or degrees.
  double open() const { return open_deg ? *open_deg : open_m.value_or(0); }

  bool operator==(const DeviceOpening&) const = default;
};

}  // namespace fissure
