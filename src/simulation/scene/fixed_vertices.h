#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"
#include "scenario/bodies.h"

namespace fissure {

/// Indices of the vertices of `rest` (a body as placeBody makes it) inside a region, ascending.
std::vector<int> verticesIn(const FixedRegion& region, const TriangleMesh& rest);

/// Indices of the vertices of `rest` inside a box of the scene's frame, bounds included, ascending.
std::vector<int> verticesIn(const BoxRegion& box, const TriangleMesh& rest);

/// Indices of the points (scene frame) inside any of the body's `fixed` regions, ascending, each once.
std::vector<int> fixedVertices(const BodySettings& body, std::span<const Vec3> vertices_m);

}  // namespace fissure
