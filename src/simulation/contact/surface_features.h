#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// An edge of a surface.
struct SurfaceEdge {
  int from = 0, to = 0;     ///< vertices
  int faces[2] = {-1, -1};  ///< the faces on both sides; -1: none, at the border of an open surface
};

/// The corners and edges that a face owns. Each corner and edge of a surface is owned by exactly one face, so
/// that tests over pairs of faces treat each pair of features once. -1: owned by another face.
struct FaceFeatures {
  std::array<int, 3> corners{-1, -1, -1};  ///< vertices
  std::array<int, 3> edges{-1, -1, -1};    ///< indices of edges()
  /// [corner] 1: the edge opposite to it is flat and counts as the inside of this face. Only without
  /// `flat_edges`.
  std::array<std::uint8_t, 3> flat{};
};

/// Faces, edges and corners of a triangle surface, with their adjacency.
class SurfaceFeatures {
 public:
  /// `flat_edges`: whether edges between coplanar faces count as edges. On a rigid tool they need not,
  /// because nothing can touch them without touching their faces.
  SurfaceFeatures(const TriangleMesh& mesh, bool flat_edges);

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<SurfaceEdge>& edges() const { return edges_; }
  const FaceFeatures& of(int face) const { return owned_[static_cast<std::size_t>(face)]; }
  /// The vertices that share an edge with a vertex.
  const std::vector<int>& neighbours(int vertex) const {
    return neighbours_[static_cast<std::size_t>(vertex)];
  }
  const std::vector<int>& facesAt(int vertex) const { return faces_at_[static_cast<std::size_t>(vertex)]; }
  /// One vertex of each shell (connected piece) of the surface.
  const std::vector<int>& shells() const { return shells_; }
  /// The corner opposite to an edge in its face number `side` (0 or 1).
  int opposite(const SurfaceEdge& edge, int side) const;

 private:
  void findShells();

  std::vector<Face> faces_;
  std::vector<SurfaceEdge> edges_;
  std::vector<FaceFeatures> owned_;
  std::vector<std::vector<int>> neighbours_, faces_at_;
  std::vector<int> shells_;
};

}  // namespace fissure
