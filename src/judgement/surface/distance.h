#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "surface/surface_tree.h"

namespace fissure {

/// Squared distance from a point to a triangle (any shape, also without area), in the square of their unit.
double distanceSquared(const TreeTriangle& triangle, const Vec3& point);

/// What a caller of distance_m needs to know: a search may stop early.
struct DistanceSearch {
  double limit_m = std::numeric_limits<double>::infinity();  ///< farther surfaces give infinity
  double enough_m = -1;  ///< once something this near is found, any distance up to this may be returned
  std::span<const std::uint8_t> left_out = {};  ///< 1: this triangle is not looked at; empty: all are
};

/// Distance from a point (tree's frame, metres) to the surface, unsigned.
double distance_m(const SurfaceTree& tree, const Vec3& point, const DistanceSearch& search = {});

}  // namespace fissure
