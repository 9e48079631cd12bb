#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/geometry.h"
#include "contact/ray.h"

namespace fissure {

/// The first triangle of a surface that a ray meets.
struct SurfaceHit {
  int face = -1;
  Ray::TriangleHit at;
};

/// A tree of bounding boxes over the triangles of one deforming body: built once for its rest shape, refitted
/// in every step.
class FaceTree {
 public:
  FaceTree(std::span<const Vec3> positions_m, const std::vector<Face>& faces);

  /// Fits all boxes to the current positions; the faces keep their place in the tree.
  void refit(std::span<const Vec3> positions_m);

  /// Is the point within the box round all faces? One that is not lies outside the body.
  bool boxHolds(const Vec3& point_m) const;

  /// The nearest hit; triangles met at the same distance: the lowest index. `tests` grows by the triangles
  /// tried.
  std::optional<SurfaceHit> firstHit(const Ray& ray, std::span<const Vec3> positions_m,
                                     long long& tests) const;

  /// Appends the faces of all leaves whose box meets this one: every face that meets it, and their neighbours
  /// in the tree. In an order that depends on the tree alone.
  void nearBox(const Vec3& low, const Vec3& high, std::vector<int>& faces) const;

 private:
  struct Box {
    Vec3 low, high;
  };
  struct Node {
    Box box;
    int first = 0;  ///< leaf: first entry of order_; inner: index of the right child (the left one follows
                    ///< its parent)
    int count = 0;  ///< leaf: number of faces; inner: 0
  };

  int build(std::span<const Vec3> positions_m, int begin, int end);
  Box boxOf(int first, int count, std::span<const Vec3> positions_m) const;
  static double entryDistance(const Box& box, const Ray& ray);

  std::vector<Face> faces_;
  std::vector<int> order_;  ///< face indices, leaf by leaf
  std::vector<Node> nodes_;
};

}  // namespace fissure
