#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// An edge of a surface.
struct SurfaceEdge {
  int from = 0, to = 0;     ///< vertices
  int faces[2] = {-1, -1};  ///< on both sides; -1: none, the border of an open surface
};

/// The corners and edges that a face stands for: each of the surface belongs to one of its faces, so that
/// pairs of faces meet each pair of their features once. -1: another face's.
struct FaceFeatures {
  std::array<int, 3> corners{-1, -1, -1};  ///< vertices
  std::array<int, 3> edges{-1, -1, -1};    ///< indices of edges()
  /// By corner, 1: the edge across from it is flat and counts as this face's inside. Only where flat edges
  /// are none.
  std::array<std::uint8_t, 3> flat{};
};

/// Faces, edges and corners of a triangle surface, each with what is next to it.
class SurfaceFeatures {
 public:
  /// `flat_edges`: whether edges between coplanar faces are edges. On a rigid tool they are none, as nothing
  /// can meet them before it meets their faces.
  SurfaceFeatures(const TriangleMesh& mesh, bool flat_edges);

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<SurfaceEdge>& edges() const { return edges_; }
  const FaceFeatures& of(int face) const { return owned_[static_cast<std::size_t>(face)]; }
  /// Vertices at the other ends of a vertex's edges.
  const std::vector<int>& neighbours(int vertex) const {
    return neighbours_[static_cast<std::size_t>(vertex)];
  }
  const std::vector<int>& facesAt(int vertex) const { return faces_at_[static_cast<std::size_t>(vertex)]; }
  /// One vertex of each of its shells, parts that no edge joins.
  const std::vector<int>& shells() const { return shells_; }
  /// The corner of a face beside an edge, `side` 0 or 1, that is not the edge's own.
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
