#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "surface/surface_tree.h"

namespace fissure {

/// Squared distance from a point to a triangle, which may be degenerate, in the square of their unit.
double distanceSquared(const TreeTriangle& triangle, const Vec3& point);

/// Limits that let distance_m() stop a search early.
struct DistanceSearch {
  double limit_m = std::numeric_limits<double>::infinity();  ///< surfaces farther than this give infinity
  /// Once a triangle at most this far is found, any distance up to this may be returned.
  double enough_m = -1;
  std::span<const std::uint8_t> left_out = {};  ///< [triangle] 1: ignored; empty: none is
};

/// Distance from a point (tree's frame, metres) to the surface, unsigned.
double distance_m(const SurfaceTree& tree, const Vec3& point, const DistanceSearch& search = {});

/// A box of any orientation, in the tree's frame, metres.
struct OrientedBox {
  Vec3 centre = Vec3::Zero();
  Mat3 axes = Mat3::Identity();  ///< its edges' directions, one per column, of unit length
  Vec3 half = Vec3::Zero();      ///< half the lengths of its edges
};

inline constexpr std::size_t kMostNear = 64;

/// A lower bound of the distance from every point of the box to the surface, at most `limit_m`; negative
/// where the box may meet the surface. Exact but for rounding where the surface next to the box is one plane.
/// `near` becomes the triangles to which any point of the box may be nearer than `near_m`, as indices in
/// tree.triangles(); where there are more than kMostNear, kMostNear + 1 of them.
double distanceBound_m(const SurfaceTree& tree, const OrientedBox& box, double limit_m, double near_m,
                       std::vector<std::size_t>& near);

}  // namespace fissure
