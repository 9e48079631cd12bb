#include "motion/device_opening.h"

#include <algorithm>

namespace fissure {

namespace {

/// 0.03 - 0.01 is more than 0.02 to a computer.
constexpr double opening_slack_m = 1e-12;

}  // namespace

OpeningAxis::OpeningAxis(const DeviceOpening& settings, const DeviceMapping& mapping,
                         const DeviceToScene& to_scene)
    : device_axis_(static_cast<int>(settings.axis)),
      open_(settings.open()),
      least_device_m_(std::min(settings.closed_device_m, settings.open_device_m)),
      most_device_m_(std::max(settings.closed_device_m, settings.open_device_m)) {
  Vec3 closed_m = mapping.origin_device_m, open_m = mapping.origin_device_m;
  closed_m[device_axis_] = settings.closed_device_m;
  open_m[device_axis_] = settings.open_device_m;
  const Vec3 from_m = to_scene.position_m(closed_m), to_m = to_scene.position_m(open_m);
  (to_m - from_m).cwiseAbs().maxCoeff(&scene_axis_);
  plane_m_ = mapping.origin_scene_m[scene_axis_];
  closed_m_ = from_m[scene_axis_];
  open_m_ = to_m[scene_axis_];
}

Vec3 OpeningAxis::inPlane(const Vec3& hand_m) const {
  Vec3 clamp_m = hand_m;
  clamp_m[scene_axis_] = plane_m_;
  return clamp_m;
}

double OpeningAxis::opening(const Vec3& hand_m) const {
  return open_ * std::clamp((hand_m[scene_axis_] - closed_m_) / (open_m_ - closed_m_), 0.0, 1.0);
}

bool OpeningAxis::saturates(const Vec3& device_m) const {
  const double at_m = device_m[device_axis_];
  return at_m < least_device_m_ - opening_slack_m || at_m > most_device_m_ + opening_slack_m;
}

}  // namespace fissure
