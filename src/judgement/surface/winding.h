#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "surface/surface_tree.h"

namespace fissure {

/// Generalized winding number of a closed, consistently oriented surface around a point (tree's frame,
/// metres): 1 inside an outward surface, 0 outside, 2 or more where it overlaps itself, negative where it is
/// inside out. For a closed surface it is the integer sum of the signs with which a ray to infinity leaves
/// through the triangles it crosses (Jacobson, Kavan and Sorkine-Hornung 2013). Points on the surface itself
/// are assigned to either side. The surface must be closed; otherwise the number depends on the ray.
int windingNumber(const SurfaceTree& tree, const Vec3& point);

/// A point that is not known.
inline const Vec3 kNowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

/// Number of triangles that do not bound the body from outside (measure/METHOD.md 2): those beneath which the
/// winding number, in the limit of zero distance, is not 1 at the centroid or close to a corner. It is 0 or
/// less for a triangle that is inside out (its normal points into the tissue, or it lies in a fold that has
/// come out on the far side, if only with its tip), and 2 or more for one that is buried in other tissue of
/// the same body. Triangles without area are not counted. `buried` ([triangle] as tree.triangles(), or empty)
/// is set to 1 where neither side of a triangle is outside of the body (winding number 0) at any of these
/// points, else to 0. A surface all of which one point sees from beneath has none, and is soon found to have
/// none; `seen_from`, where the search for that point begins and ended, saves time when it is kept from one
/// step to the next, and changes no number.
int countInvertedTriangles(const SurfaceTree& tree, std::span<std::uint8_t> buried = {},
                           Vec3* seen_from = nullptr);

}  // namespace fissure
