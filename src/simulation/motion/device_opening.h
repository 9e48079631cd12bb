#pragma once

#include "base/geometry.h"
#include "motion/device_to_scene.h"
#include "scenario/clamps.h"

namespace fissure {

/// The device axis that opens a clamp, apart from the plane of the two that move it. The axes of device and
/// scene are the same but for order and sign, so that each device axis is one coordinate in the scene.
class OpeningAxis {
 public:
  OpeningAxis(const DeviceOpening& settings, const DeviceMapping& mapping, const DeviceToScene& to_scene);

  /// Of the clamp, when the whole mapped hand is at `hand_m`: in the plane through origin_scene_m.
  Vec3 inPlane(const Vec3& hand_m) const;
  /// Of the jaws then, metres or degrees, within 0 and the settings' opening.
  double opening(const Vec3& hand_m) const;
  /// Whether a sample of the device lies beyond the places that are closed and open.
  bool saturates(const Vec3& device_m) const;

 private:
  int device_axis_;
  int scene_axis_ = 0;
  double plane_m_;   ///< the coordinate along scene_axis_ where the clamp stays
  double closed_m_;  ///< and where the hand has closed it
  double open_m_;
  double open_;  ///< opening at open_m_
  double least_device_m_, most_device_m_;
};

}  // namespace fissure
