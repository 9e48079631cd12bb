#include "motion/device_to_scene.h"

#include <fmt/core.h>

#include <cmath>

#include "base/error.h"

namespace fissure {
namespace {

/// The signed unit vector of a device axis: "x", "-y", "+z" ...
Vec3 deviceAxis(const std::string& name, const std::string& where) {
  const bool has_sign = name.size() == 2 && (name[0] == '-' || name[0] == '+');
  const char letter = name.empty() ? '?' : name.back();
  if ((name.size() != 1 && !has_sign) || letter < 'x' || letter > 'z')
    throw InputError(
        fmt::format("{}.axes: \"{}\", expected x, y or z, with or without a minus", where, name));
  return (has_sign && name[0] == '-' ? -1.0 : 1.0) * Vec3::Unit(letter - 'x');
}

Mat3 rotationOfAxes(const std::array<std::string, 3>& axes, const std::string& where) {
  Mat3 rotation;
  for (int i = 0; i < 3; ++i)
    rotation.row(i) = deviceAxis(axes[static_cast<std::size_t>(i)], where).transpose();
  // A mirrored hand would turn every rotation the wrong way round.
  if (rotation.determinant() != 1)
    throw InputError(
        fmt::format("{}.axes: {}, {}, {} is no right-handed frame, expected three axes of which an even "
                    "number is swapped or negated",
                    where, axes[0], axes[1], axes[2]));
  return rotation;
}

}  // namespace

DeviceToScene::DeviceToScene(const DeviceMapping& mapping, const std::string& where)
    : axes_(rotationOfAxes(mapping.sceneAxes(), where)),
      rotation_(axes_),
      scale_(mapping.scale),
      origin_device_m_(mapping.origin_device_m),
      origin_scene_m_(mapping.origin_scene_m),
      mount_(mapping.mount.normalized()) {
  if (!(scale_ > 0) || !std::isfinite(scale_)) throw InputError(where + ".scale: expected a value above 0");
  if (!(mapping.mount.norm() > 1e-6))
    throw InputError(where + ".mount: expected a unit quaternion x, y, z, w");
}

}  // namespace fissure
