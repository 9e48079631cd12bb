#include "render/ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fissure {
namespace {

constexpr double plain_radii = 0.55;  ///< up to there the ground has one colour
constexpr int sectors = 64;
constexpr int rings = 8;  ///< in which it fades from there to its border

/// `colour` fading into the background between 55 % and 100 % of the radius.
Colour faded(Colour colour, double distance_in_radii) {
  const double x = std::clamp((distance_in_radii - plain_radii) / (1 - plain_radii), 0.0, 1.0);
  const double share = x * x * (3 - 2 * x);
  const auto mix = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {mix(colour.r, palette::background.r), mix(colour.g, palette::background.g),
          mix(colour.b, palette::background.b)};
}

struct Disc {
  Vec3 centre_m;
  double radius_m;

  /// Adds a point at (x, z) from the centre, in radii.
  void add(double x, double z, Colour colour, VertexBatch& batch) const {
    batch.add(centre_m + radius_m * Vec3(x, 0, z), faded(colour, std::hypot(x, z)));
  }
};

/// A disc in one colour, and rings around it in which it fades.
void addFill(const Disc& disc, VertexBatch& fill) {
  std::vector<double> radii = {0};
  for (int ring = 0; ring <= rings; ++ring) radii.push_back(plain_radii + (1 - plain_radii) * ring / rings);
  for (int sector = 0; sector < sectors; ++sector) {
    const double from = 2 * std::numbers::pi * sector / sectors;
    const double to = 2 * std::numbers::pi * (sector + 1) / sectors;
    const auto add = [&](double radius, double angle) {
      disc.add(radius * std::sin(angle), radius * std::cos(angle), palette::ground, fill);
    };
    for (std::size_t ring = 1; ring < radii.size(); ++ring) {
      const double inner = radii[ring - 1], outer = radii[ring];
      add(inner, from), add(outer, from), add(outer, to);
      if (inner > 0) add(inner, from), add(outer, to), add(inner, to);
    }
  }
}

/// A line across the disc at this distance from its centre, in radii: one piece where the ground has one
/// colour, and short ones where it fades.
void addLine(const Disc& disc, double offset, bool along_z, VertexBatch& grid) {
  const double end = std::sqrt(1 - offset * offset);
  const double plain = std::sqrt(std::max(0.0, plain_radii * plain_radii - offset * offset));
  std::vector<double> stops;
  for (int i = rings; i >= 0; --i) stops.push_back(-plain - (end - plain) * i / rings);
  for (int i = plain > 0 ? 0 : 1; i <= rings; ++i) stops.push_back(plain + (end - plain) * i / rings);
  for (std::size_t i = 1; i < stops.size(); ++i)
    for (const double at : {stops[i - 1], stops[i]})
      disc.add(along_z ? offset : at, along_z ? at : offset, palette::grid, grid);
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
  while (2 * radius_m / plane.spacing_m > 100) plane.spacing_m *= 10;
  const Disc disc{centre_m, radius_m};
  addFill(disc, plane.fill);
  for (const bool along_z : {true, false}) {
    const double middle_m = along_z ? centre_m.x() : centre_m.z();
    const auto last = static_cast<int>(std::ceil((middle_m + radius_m) / plane.spacing_m));
    for (auto i = static_cast<int>(std::floor((middle_m - radius_m) / plane.spacing_m)); i <= last; ++i)
      if (const double offset = (i * plane.spacing_m - middle_m) / radius_m; std::abs(offset) < 1)
        addLine(disc, offset, along_z, plane.grid);
  }
  return plane;
}

}  // namespace fissure
