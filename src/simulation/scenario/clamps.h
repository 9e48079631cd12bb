#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/shapes.h"

namespace fissure {

/// A rigid part of a clamp, with its pose in the clamp's frame when the clamp is closed.
struct ClampPart {
  SurfaceShape shape = BoxShape{};
  Vec3 position_m = Vec3::Zero();
  Quat orientation = Quat::Identity();
  /// Its shape is mirrored in the plane x = 0 of the shape's own frame; no key of files.
  bool mirrored = false;

  bool operator==(const ClampPart&) const = default;
};

/// The motion by which the jaws of a clamp open.
enum class ClampOpening {
  parallel,  ///< they slide apart along x; the opening is the distance between them, metres
  hinged,    ///< they turn about a hinge along z; the opening is the angle between them, degrees
};

/// Settings that make a tool a clamp: two rigid jaws, which have contact with the tissue but not with each
/// other. In the clamp's frame the jaws lie left (x < 0) and right (x > 0) of the plane x = 0, hinged ones
/// below their hinge. At an opening of 0 the clamp is closed and jaws may touch; each jaw moves by half of
/// the opening. The tool's shape is that of the right jaw; its nodes, friction and force limit hold for each
/// jaw.
struct ClampSettings {
  ClampOpening opening = ClampOpening::parallel;
  double hinge_height_m = 0;
  Vec3 jaw_position_m = Vec3::Zero();
  Quat jaw_orientation = Quat::Identity();
  std::optional<ClampPart> left_jaw;
  std::vector<ClampPart> handle;

  bool operator==(const ClampSettings&) const = default;
};

/// The largest angle between hinged jaws, degrees: each has then turned by 90.
constexpr double max_opening_deg = 180;

/// An axis of a haptic device, in the frame of its log.
enum class DeviceAxis { x, y, z };

/// How a replayed device opens a clamp: the opening is linear in the coordinate along one device axis,
/// between a closed and an open position. This axis then does not move the clamp, which stays in the plane of
/// the other two through origin_scene_m. Beyond both positions the opening stays constant, and such samples
/// are counted.
struct DeviceOpening {
  DeviceAxis axis = DeviceAxis::x;
  double closed_device_m = 0;
  double open_device_m = 0;
  std::optional<double> open_m;
  std::optional<double> open_deg;

  /// The opening at open_device_m, in metres or, for hinged jaws, degrees.
  double open() const { return open_deg ? *open_deg : open_m.value_or(0); }

  bool operator==(const DeviceOpening&) const = default;
};

/// The reason why openings in metres have the least value 0.
inline constexpr const char* jaws_touch = "the jaws touch there";

template <class Io>
void describe(Io& io, ClampPart& p) {
  io.tagged("shape", p.shape,
            Key("Surface of this part, in its own frame.").oneOf(catalog().tool_shapes).required());
  io.field("position_m", p.position_m, Key("Where the shape's own origin is in the closed clamp's frame."));
  io.field("orientation", p.orientation,
           Key("Rotation of the part in the closed clamp's frame, a unit quaternion [x, y, z, w].").noUnit());
}

template <class Io>
void describe(Io& io, ClampSettings& c) {
  io.field("opening", c.opening, Key("How the jaws open.").oneOf(catalog().clamp_openings).required());
  io.field("hinge_height_m", c.hinge_height_m,
           Key("Height (y) of the hinge in the clamp's frame; it lies in the plane x = 0, and the jaws are "
               "below it.")
               .required()
               .onlyIf(c.opening == ClampOpening::hinged, "opening hinged"));
  io.field("jaw_position_m", c.jaw_position_m,
           Key("Where the origin of the right jaw's shape is in the closed clamp's frame.").required());
  io.field(
      "jaw_orientation", c.jaw_orientation,
      Key("Rotation of the right jaw in the closed clamp's frame, a unit quaternion [x, y, z, w].").noUnit());
  io.field("left_jaw", c.left_jaw,
           Key("The left jaw, where it is no mirror image of the right one.")
               .otherwise("the mirror image of the right jaw in the plane x = 0"));
  io.field("handle", c.handle,
           Key("Parts that are drawn with the clamp in frames and never meet anything.").items(0));
}

template <class Io>
void describe(Io& io, DeviceOpening& o) {
  io.field("axis", o.axis,
           Key("Axis of the device, as the log has it, that opens the clamp; the other two move it.")
               .oneOf(catalog().device_axes)
               .expecting("an axis of the device: x, y or z")
               .required());
  io.field(
      "closed_device_m", o.closed_device_m,
      Key("Coordinate along this axis, in the device's frame, at which the clamp is closed.").required());
  io.field("open_device_m", o.open_device_m,
           Key("Coordinate along this axis, on either side of the closed one, at which the clamp is open.")
               .required());
  io.field("open_m", o.open_m,
           Key("Opening at `open_device_m` of a clamp with parallel jaws; not 0.")
               .atLeast(0, jaws_touch)
               .otherwise("required of parallel jaws, an error of hinged ones"));
  io.field("open_deg", o.open_deg,
           Key("Opening at `open_device_m` of a clamp with hinged jaws; not 0.")
               .between(0, max_opening_deg)
               .otherwise("required of hinged jaws, an error of parallel ones"));
}

}  // namespace fissure
