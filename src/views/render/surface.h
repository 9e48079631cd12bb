#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// An edge of a triangle surface and the faces beside it; face_b is -1 where the surface ends.
struct SurfaceEdge {
  int a = 0;
  int b = 0;
  int face_a = 0;
  int face_b = -1;
};

/// A triangle surface's unchanging part, worked out once: its faces and edges. Vertices are given anew for
/// each picture, in the order that the faces index.
class Surface {
 public:
  Surface(std::vector<Face> faces, int vertex_count);

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<SurfaceEdge>& edges() const { return edges_; }
  /// True when all three corners are drawable.
  bool faceDrawable(std::span<const Vec3> vertices_m, int face) const;
  /// One unit outward normal a face; zero where the face is degenerate or not drawable.
  std::vector<Vec3> faceNormals(std::span<const Vec3> vertices_m) const;
  /// Three unit normals a face, for smooth shading: at each corner the area-weighted mean over the faces
  /// around the vertex that turn less than `crease_deg` from this one, so that sharp edges stay sharp.
  std::vector<std::array<Vec3, 3>> cornerNormals(std::span<const Vec3> vertices_m, double crease_deg) const;

 private:
  void findEdges();

  std::vector<Face> faces_;
  std::vector<SurfaceEdge> edges_;
  std::vector<std::vector<int>> faces_around_;  ///< of each vertex
};

/// Where two triangle surfaces cross: a segment for each crossing pair of drawable triangles, metres.
/// Triangles in one plane give none.
std::vector<std::array<Vec3, 2>> cutSegments(const std::vector<Face>& faces_a,
                                             std::span<const Vec3> vertices_a_m,
                                             const std::vector<Face>& faces_b,
                                             std::span<const Vec3> vertices_b_m);

}  // namespace fissure
