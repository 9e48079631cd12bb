#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Corners of a triangle, counter-clockwise seen from outside, in the tree's frame, metres.
struct TreeTriangle {
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  Vec3 c = Vec3::Zero();

  Vec3 doubleAreaNormal() const { return (b - a).cross(c - a); }
};

/// An axis-aligned box in the tree's frame, metres.
struct TreeBox {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();

  double distanceSquared(const Vec3& point) const {
    return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
  }
};

/// Nodes are stored depth first: an inner node's children are the next node and that one's `skip`.
struct TreeNode {
  int skip = 0;   ///< the first node that is not below this one
  int first = 0;  ///< of the triangles of a leaf
  int count = 0;  ///< of the triangles of a leaf; 0: an inner node
};

/// A triangle surface that moves, with a hierarchy of boxes over its triangles. The hierarchy's shape is made
/// once; a step only refits the boxes, and allocates nothing. All geometry is kept in the tree's own frame:
/// the mesh's, turned by a fixed rotation (frame(), unless another is given) under which no direction of
/// ordinary scenes is an axis, so that rays along its z meet no edge-on triangles of boxes and grids.
class SurfaceTree {
 public:
  /// `mesh` gives the triangles and their first positions; `faces` stay, vertices move. At least one
  /// triangle.
  explicit SurfaceTree(const TriangleMesh& mesh, const Mat3& to_tree = frame());

  /// Moves the vertices (as many as the mesh has, scene frame, metres, finite); the positions before become
  /// previous().
  void update(std::span<const Vec3> vertices_m);
  /// Makes the present positions the previous ones too: the surface has not moved.
  void forgetMotion();

  /// The rotation from the scene's frame to that of every tree that is not given another.
  static const Mat3& frame();
  static Vec3 toTree(const Vec3& in_scene) { return frame() * in_scene; }

  const std::vector<TreeNode>& nodes() const { return nodes_; }
  const std::vector<TreeBox>& boxes() const { return boxes_; }  ///< of the present positions, one a node
  const std::vector<TreeBox>& previousBoxes() const {
    return previous_boxes_;
  }                                                                          ///< of the previous positions
  const std::vector<TreeTriangle>& triangles() const { return triangles_; }  ///< in the order of the leaves
  const std::vector<TreeTriangle>& previous() const { return previous_; }
  const std::vector<int>& faceIndices() const { return order_; }  ///< in the mesh, of triangles()

 private:
  void build(int first, int count, std::span<const Vec3> centroids);
  void gather();
  void refit();

  Mat3 to_tree_;
  std::vector<int> order_;   // of the mesh's faces, leaf by leaf
  std::vector<Face> faces_;  // in this order
  std::vector<Vec3> vertices_;
  std::vector<TreeTriangle> triangles_;
  std::vector<TreeTriangle> previous_;
  std::vector<TreeNode> nodes_;
  std::vector<TreeBox> boxes_;
  std::vector<TreeBox> previous_boxes_;
};

}  // namespace fissure
