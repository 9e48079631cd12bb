#pragma once

#include <cstdint>
#include <span>

#include "surface/surface_tree.h"

namespace fissure {

/// Generalized winding number of a closed, consistently oriented surface around a point (tree's frame,
/// metres): 1 inside an outward surface, 0 outside, 2 or more where it overlaps itself, negative where it is
/// inside out. For a closed surface it is the integer sum of the signs with which a ray to infinity leaves
/// through the triangles it crosses (Jacobson, Kavan and Sorkine-Hornung 2013). Points on the surface itself
/// are given to either side. The surface must be closed: else the number depends on the ray.
int windingNumber(const SurfaceTree& tree, const Vec3& point);

/// The winding number just beneath a point of triangle `index` of tree.triangles(), against its normal: 1 for
/// a triangle of a proper outward surface. In the limit of no distance: no step length enters.
int windingBeneath(const SurfaceTree& tree, std::size_t index, const Vec3& point);

/// How many triangles do not bound the body from outside: those whose windingBeneath is not 1 at the centroid
/// or close by a corner, so 0 or less for a triangle turned inside out (its normal points into the tissue, or
/// it lies in a fold that has come out on the far side, if only with its tip), 2 or more for one buried in
/// other tissue of the same body. Triangles without area are not counted: they have no inside.
/// `buried`, one a triangle of tree.triangles() or empty, is set to 1 where neither side of a triangle is
/// outside of the body (winding number 0) at any of these places, else to 0.
int countInvertedTriangles(const SurfaceTree& tree, std::span<std::uint8_t> buried = {});

}  // namespace fissure
