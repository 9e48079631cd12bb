#include "surface/surface_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "base/rotation.h"

namespace fissure {

namespace {

constexpr int kTrianglesPerLeaf = 4;

// Rounding in the edge tests of windingNumber can move an edge by some 1e-15 of its length. Boxes wider than
// that never cut off a triangle that its neighbour, testing the same edge, takes to be hit.
constexpr double kPadding = 1e-13;

TreeBox joined(const TreeBox& one, const TreeBox& other) {
  return {one.low.cwiseMin(other.low), one.high.cwiseMax(other.high)};
}

TreeBox boxAround(std::span<const TreeTriangle> triangles) {
  TreeBox box{triangles.front().a, triangles.front().a};
  for (const TreeTriangle& t : triangles) {
    box.low = box.low.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c);
    box.high = box.high.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
  }
  const double padding = kPadding * (box.high - box.low).maxCoeff();
  return {box.low.array() - padding, box.high.array() + padding};
}

}  // namespace

const Mat3& SurfaceTree::frame() {
  static const Mat3 rotation =
      matrixAbout(Vec3(std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0)).normalized(), 1.0);
  return rotation;
}

SurfaceTree::SurfaceTree(const TriangleMesh& mesh, const Mat3& to_tree)
    : to_tree_(to_tree),
      order_(mesh.faces.size()),
      faces_(mesh.faces.size()),
      vertices_(mesh.vertices_m.size()) {
  assert(!mesh.faces.empty());
  const int count = static_cast<int>(mesh.faces.size());
  std::vector<Vec3> centroids;
  centroids.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    const auto corner = [&](int i) { return mesh.vertices_m[static_cast<std::size_t>(face[i])]; };
    centroids.push_back(to_tree_ * (corner(0) + corner(1) + corner(2)) / 3.0);
  }
  std::iota(order_.begin(), order_.end(), 0);
  build(0, count, centroids);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    faces_[i] = mesh.faces[static_cast<std::size_t>(order_[i])];
  }
  triangles_.resize(faces_.size());
  previous_.resize(faces_.size());
  boxes_.resize(nodes_.size());
  previous_boxes_.resize(nodes_.size());
  update(mesh.vertices_m);
  forgetMotion();
}

void SurfaceTree::build(int first, int count, std::span<const Vec3> centroids) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({0, first, count <= kTrianglesPerLeaf ? count : 0});
  if (count > kTrianglesPerLeaf) {
    const auto begin = order_.begin() + first;
    const auto centroid = [&](int face) -> const Vec3& { return centroids[static_cast<std::size_t>(face)]; };
    TreeBox box{centroid(*begin), centroid(*begin)};
    for (auto face = begin; face != begin + count; ++face) {
      box = joined(box, {centroid(*face), centroid(*face)});
    }
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    // The face index decides ties, so that the tree does not depend on the library's sorting.
    std::nth_element(begin, begin + count / 2, begin + count, [&](int one, int other) {
      return std::pair(centroid(one)[axis], one) < std::pair(centroid(other)[axis], other);
    });
    build(first, count / 2, centroids);
    build(first + count / 2, count - count / 2, centroids);
  }
  nodes_[node].skip = static_cast<int>(nodes_.size());
}

void SurfaceTree::update(std::span<const Vec3> vertices_m) {
  assert(vertices_m.size() == vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) vertices_[i] = to_tree_ * vertices_m[i];
  triangles_.swap(previous_);
  boxes_.swap(previous_boxes_);
  gather();
  refit();
}

void SurfaceTree::forgetMotion() {
  previous_ = triangles_;
  previous_boxes_ = boxes_;
}

void SurfaceTree::gather() {
  const auto vertex = [&](int index) -> const Vec3& { return vertices_[static_cast<std::size_t>(index)]; };
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    triangles_[i] = {vertex(faces_[i][0]), vertex(faces_[i][1]), vertex(faces_[i][2])};
  }
}

void SurfaceTree::refit() {
  const std::span<const TreeTriangle> all = triangles_;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const TreeNode& node = nodes_[i];
    if (node.count > 0) {
      boxes_[i] =
          boxAround(all.subspan(static_cast<std::size_t>(node.first), static_cast<std::size_t>(node.count)));
    } else {
      boxes_[i] = joined(boxes_[i + 1], boxes_[static_cast<std::size_t>(nodes_[i + 1].skip)]);
    }
  }
}

}  // namespace fissure
