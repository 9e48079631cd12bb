#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// An edge of a triangle surface and its adjacent faces; face_b is -1 at a border of the surface.
struct SurfaceEdge {
  int a = 0;
  int b = 0;
  int face_a = 0;
  int face_b = -1;
};

/// The constant topology of a triangle surface: its faces and edges. Positions of the vertices are given for
/// each picture.
class Surface {
 public:
  Surface(std::vector<Face> faces, int vertex_count);

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<SurfaceEdge>& edges() const { return edges_; }
  /// True when all three corners are drawable.
  bool faceDrawable(std::span<const Vec3> vertices_m, int face) const;
  /// [face] unit outward normal; zero where the face is degenerate or not drawable.
  std::vector<Vec3> faceNormals(std::span<const Vec3> vertices_m) const;
  /// [face][corner] unit normals for smooth shading: the area-weighted mean over those faces around the
  /// vertex whose normals deviate by less than `crease_deg` from this face's, so that sharp edges stay sharp.
  std::vector<std::array<Vec3, 3>> cornerNormals(std::span<const Vec3> vertices_m, double crease_deg) const;

 private:
  void findEdges();

  std::vector<Face> faces_;
  std::vector<SurfaceEdge> edges_;
  std::vector<std::vector<int>> faces_around_;  ///< [vertex] its faces
};

/// The intersection of two triangle surfaces: one segment for each pair of intersecting, drawable triangles,
/// in the frame of the vertices, metres. Coplanar triangles give none.
std::vector<std::array<Vec3, 2>> cutSegments(const std::vector<Face>& faces_a,
                                             std::span<const Vec3> vertices_a_m,
                                             const std::vector<Face>& faces_b,
                                             std::span<const Vec3> vertices_b_m);

}  // namespace fissure
