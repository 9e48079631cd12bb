#include "motion/jaw_poses.h"

#include <numbers>

#include "base/rotation.h"

namespace fissure {

namespace {

/// The pose of one jaw in the clamp's frame at an opening. A positive turn about z takes what hangs below the
/// hinge to the right.
Pose jawInClamp(const ClampSettings& clamp, const ClampPart& closed, double side, double opening) {
  const Quat orientation = closed.orientation.normalized();
  if (clamp.opening == ClampOpening::parallel)
    return {closed.position_m + Vec3(side * 0.5 * opening, 0, 0), orientation};
  const Vec3 hinge_m(0, clamp.hinge_height_m, 0);
  const Quat turn = quaternionAbout(Vec3::UnitZ(), side * 0.5 * opening * std::numbers::pi / 180);
  return {hinge_m + turn * (closed.position_m - hinge_m), turn * orientation};
}

}  // namespace

std::array<Pose, 2> jawPoses(const ClampSettings& clamp, const std::array<ClampPart, 2>& closed,
                             const Pose& pose, double opening) {
  const auto place = [&](const ClampPart& jaw, double side) {
    const Pose in_clamp = jawInClamp(clamp, jaw, side, opening);
    return Pose{pose.toScene(in_clamp.position_m), pose.orientation * in_clamp.orientation};
  };
  return {place(closed[0], -1), place(closed[1], 1)};
}

}  // namespace fissure
