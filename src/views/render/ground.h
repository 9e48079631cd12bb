#pragma once

#include <vector>

#include "base/geometry.h"
#include "render/palette.h"

namespace fissure {

/// Vertices with colours, as OpenGL takes them: three (triangles) or two (lines) make one piece.
struct VertexBatch {
  std::vector<float> xyz_m;
  std::vector<std::uint8_t> rgba;

  void add(const Vec3& point_m, Colour colour);
  int size() const { return static_cast<int>(xyz_m.size() / 3); }
};

/// A light plane with a grid that fades into the background at its round border.
struct GroundPlane {
  VertexBatch fill;  ///< triangles
  VertexBatch grid;  ///< lines
  double spacing_m = 0.01;
};

/// The ground below points in view: centred under them, 1.6 times their horizontal extent in radius, at least
/// 0.05 m. Grid lines lie at multiples of spacing_m in the scene: a centimetre, or a power of ten of it when
/// that would be more than 100 lines.
GroundPlane makeGroundPlane(const std::vector<Vec3>& points_m, double height_m);

}  // namespace fissure
