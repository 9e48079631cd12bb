#pragma once

#include <algorithm>
#include <cmath>

#include "base/geometry.h"

namespace fissure {

/// Two lobes of a half ellipsoid on its flat side, parted by a slit along z and joined below it: a fissure.
/// The origin is the middle of the flat side, y up. The same on both sides of x = 0, to the last bit.
struct LobesShape {
  Vec3 size_m = {0.08, 0.04, 0.08};  ///< of the whole, > 0: across the slit, in height, along the slit
  double slit_depth_m = 0.028;       ///< from the top, in the middle, > 0, below the height
  double slit_width_m = 0.001;  ///< at the top, > 0, below half the size across; closes towards its floor
  /// Longest edge of the cells, two triangles each, of the upright block whose surface is bent into the
  /// ellipsoid, > 0.
  double edge_m = 0.006;

  struct Cells {
    double across = 0;      ///< in one lobe
    double joined = 0;      ///< in height, below the slit's floor
    double parted = 0;      ///< in height, above it
    double half_along = 0;  ///< on each side of z = 0
  };
  Cells cells() const {
    const auto along = [this](double length_m) { return std::max(1.0, std::ceil(length_m / edge_m - 1e-9)); };
    return {along(size_m.x() / 2), along(size_m.y() - slit_depth_m), along(slit_depth_m),
            along(size_m.z() / 2)};
  }
  double triangles() const {
    const Cells n = cells();
    const double height = n.joined + n.parted;
    return 8 * (n.half_along * (2 * n.across + height + n.parted) + height * n.across);
  }

  bool operator==(const LobesShape&) const = default;
};

}  // namespace fissure
