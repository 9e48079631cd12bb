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

/// A node of the tree. Nodes are stored depth first: the children of an inner node are the next node and the
/// node at the next node's `skip`.
struct TreeNode {
  int skip = 0;   ///< index of the first node behind the subtree of this one
  int first = 0;  ///< leaf: of its triangles
  int count = 0;  ///< leaf: number of its triangles; inner node: 0
};

/// A moving triangle surface with a hierarchy of bounding boxes. The topology of the hierarchy is built once;
/// a step only refits the boxes and allocates nothing. All geometry is in the tree's own frame: that of the
/// mesh turned by a fixed rotation (frame(), unless another is given), after which no direction of ordinary
/// scenes is an axis, so that rays along its z meet no edge-on triangles of boxes and grids.
class SurfaceTree {
 public:
  /// `mesh` has the triangles, at least one, and the first positions of the vertices. `to_tree`: rotation
  /// from the mesh's frame to the tree's.
  explicit SurfaceTree(const TriangleMesh& mesh, const Mat3& to_tree = frame());

  /// Moves the vertices to these positions (as many as the mesh has, in the mesh's frame, metres, finite);
  /// the positions before become previous().
  void update(std::span<const Vec3> vertices_m);
  /// Sets the previous positions to the present ones, as if the surface had not moved.
  void forgetMotion();

  /// The default rotation from the mesh's (usually the scene's) frame to the tree's.
  static const Mat3& frame();
  static Vec3 toTree(const Vec3& in_scene) { return frame() * in_scene; }

  const std::vector<TreeNode>& nodes() const { return nodes_; }
  const std::vector<TreeBox>& boxes() const { return boxes_; }  ///< [node] boxes of the present positions
  /// [node] boxes of the previous positions.
  const std::vector<TreeBox>& previousBoxes() const { return previous_boxes_; }
  /// Present positions, in the order of the leaves.
  const std::vector<TreeTriangle>& triangles() const { return triangles_; }
  const std::vector<TreeTriangle>& previous() const { return previous_; }
  /// For each of triangles(), its face in the mesh.
  const std::vector<int>& faceIndices() const { return order_; }

 private:
  void build(int first, int count, std::span<const Vec3> centroids);
  void gather();
  void refit();

  Mat3 to_tree_;
  std::vector<int> order_;   // indices of the mesh's faces, leaf by leaf
  std::vector<Face> faces_;  // the faces in this order
  std::vector<Vec3> vertices_;
  std::vector<TreeTriangle> triangles_;
  std::vector<TreeTriangle> previous_;
  std::vector<TreeNode> nodes_;
  std::vector<TreeBox> boxes_;
  std::vector<TreeBox> previous_boxes_;
};

}  // namespace fissure
