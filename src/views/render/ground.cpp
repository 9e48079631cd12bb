#include "render/ground.h"

#include <algorithm>
#include <cmath>

namespace fissure {
namespace {

/// `colour` fading into the background between 55 % and 100 % of the radius.
Colour faded(Colour colour, double distance_in_radii) {
  const double x = std::clamp((distance_in_radii - 0.55) / 0.45, 0.0, 1.0);
  const double share = x * x * (3 - 2 * x);
  const auto mix = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {mix(colour.r, palette::background.r), mix(colour.g, palette::background.g),
          mix(colour.b, palette::background.b)};
}

}  // namespace

void VertexBatch::add(const Vec3& point_m, Colour colour) {
  for (int i = 0; i < 3; ++i) {
    xyz_m.push_back(static_cast<float>(point_m[i]));
  }
  rgba.insert(rgba.end(), {colour.r, colour.g, colour.b, colour.a});
}

GroundPlane makeGroundPlane(const std::vector<Vec3>& points_m, double height_m) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point_m : points_m) {
    box.extend(point_m);
  }
  const Vec3 centre_m(box.center().x(), height_m, box.center().z());
  const double extent_m = std::hypot(box.sizes().x(), box.sizes().z());
  const double radius_m = std::max(0.05, 1.6 * extent_m);

  GroundPlane plane;
  while (2 * radius_m / plane.spacing_m > 100) {
    plane.spacing_m *= 10;
  }
  const auto shade = [&](const Vec3& p, Colour colour) {
    return faded(colour, (p - centre_m).norm() / radius_m);
  };
  const auto at = [&](int i, int k) { return Vec3(i * plane.spacing_m, height_m, k * plane.spacing_m); };
  const int first_x = static_cast<int>(std::floor((centre_m.x() - radius_m) / plane.spacing_m));
  const int last_x = static_cast<int>(std::ceil((centre_m.x() + radius_m) / plane.spacing_m));
  const int first_z = static_cast<int>(std::floor((centre_m.z() - radius_m) / plane.spacing_m));
  const int last_z = static_cast<int>(std::ceil((centre_m.z() + radius_m) / plane.spacing_m));
  for (int i = first_x; i < last_x; ++i) {
    for (int k = first_z; k < last_z; ++k) {
      if ((at(i, k) - centre_m).norm() > radius_m + 2 * plane.spacing_m) {
        continue;
      }
      for (const Vec3& p :
           {at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i + 1, k)}) {
        plane.fill.add(p, shade(p, palette::ground));
      }
      for (const Vec3& p : {at(i, k), at(i + 1, k), at(i, k), at(i, k + 1)}) {
        plane.grid.add(p, shade(p, palette::grid));
      }
    }
  }
  return plane;
}

}  // namespace fissure
