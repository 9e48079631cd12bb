#pragma once

#include <string>

#include "base/geometry.h"
#include "scenario/motions.h"

namespace fissure {

/// Maps poses of a device, in the device's frame, to poses of the tool in the scene frame:
///   position = origin_scene_m + scale * R * (p_device - origin_device_m)
///   orientation = R * q_device * mount
class DeviceToScene {
 public:
  /// `where`: the key path of the settings, for messages. Throws InputError unless `axes` are the three
  /// device axes, with signs, in a right-handed order.
  DeviceToScene(const DeviceMapping& mapping, const std::string& where);

  Vec3 position_m(const Vec3& device_m) const {
    return origin_scene_m_ + scale_ * (axes_ * (device_m - origin_device_m_));
  }
  Quat orientation(const Quat& device) const { return (rotation_ * device * mount_).normalized(); }
  /// Orientation of the tool where the log has no orientations: the mount alone.
  const Quat& mount() const { return mount_; }

 private:
  Mat3 axes_;      ///< R as a matrix of 0, 1 and -1, without rounding
  Quat rotation_;  ///< R as a quaternion
  double scale_;
  Vec3 origin_device_m_;
  Vec3 origin_scene_m_;
  Quat mount_;
};

}  // namespace fissure
