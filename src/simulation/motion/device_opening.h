#pragma once

#include "base/geometry.h"
#include "motion/device_to_scene.h"
#include "scenario/clamps.h"

namespace fissure {

/// Splits the replayed hand motion of a clamp into its opening, along one device axis, and its motion in the
/// plane of the other two. Device and scene axes differ only in order and sign, so each device axis is one
/// coordinate of the scene.
class OpeningAxis {
 public:
  OpeningAxis(const DeviceOpening& settings, const DeviceMapping& mapping, const DeviceToScene& to_scene);

  /// Position of the clamp in the scene frame for a hand at `hand_m` (scene frame): its projection on the
  /// plane through origin_scene_m.
  Vec3 inPlane(const Vec3& hand_m) const;
  /// Opening of the jaws for a hand at `hand_m` (scene frame), metres or degrees, clamped to 0 .. the
  /// settings' opening.
  double opening(const Vec3& hand_m) const;
  /// Whether a sample (device frame) lies beyond the closed or the open position.
  bool saturates(const Vec3& device_m) const;

 private:
  int device_axis_;
  int scene_axis_ = 0;
  double plane_m_;   ///< coordinate along scene_axis_ at which the clamp stays
  double closed_m_;  ///< coordinate along scene_axis_ at which the hand has closed it
  double open_m_;
  double open_;  ///< opening at open_m_
  double least_device_m_, most_device_m_;
};

}  // namespace fissure
