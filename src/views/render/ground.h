#pragma once

#include <vector>

#include "base/geometry.h"
#include "render/palette.h"

namespace fissure {

/// Coloured vertices for OpenGL, three per triangle or two per line.
struct VertexBatch {
  std::vector<float> xyz_m;
  std::vector<std::uint8_t> rgba;

  void add(const Vec3& point_m, Colour colour);
  int size() const { return static_cast<int>(xyz_m.size() / 3); }
};

/// The geometry of the ground: a light disc with a grid, which fades into the background at its border.
struct GroundPlane {
  VertexBatch fill;  ///< triangles
  VertexBatch grid;  ///< lines
  double spacing_m = 0.01;
};

/// The ground below these points (scene frame), at height y = `height_m`: a disc centred under them, with a
/// radius of 1.6 times their horizontal extent, at least 0.05 m. Grid lines lie at multiples of spacing_m in
/// the scene: a centimetre, or a larger power of ten where there would be more than 100 lines.
GroundPlane makeGroundPlane(const std::vector<Vec3>& points_m, double height_m);

}  // namespace fissure
