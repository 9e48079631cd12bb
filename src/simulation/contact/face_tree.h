#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/geometry.h"
#include "contact/ray.h"

namespace fissure {

/// The first triangle of a surface that a ray hits.
struct SurfaceHit {
  int face = -1;
  Ray::TriangleHit at;
};

/// A tree of axis-parallel bounding boxes over the triangles of one deforming body, built once for its rest
/// shape and refitted in every step.
class FaceTree {
 public:
  FaceTree(std::span<const Vec3> positions_m, const std::vector<Face>& faces);

  /// Fits all boxes to the current positions; the topology of the tree does not change.
  void refit(std::span<const Vec3> positions_m);

  /// Whether the point is in the bounding box of all faces; if not, it is outside the body.
  bool boxHolds(const Vec3& point_m) const;

  /// The nearest hit of the ray; at equal distances that of the lowest face index; no value where the ray
  /// misses. `tests` is raised by the number of triangles tested.
  std::optional<SurfaceHit> firstHit(const Ray& ray, std::span<const Vec3> positions_m,
                                     long long& tests) const;

  /// Appends the faces of all leaves whose box meets the box from `low` to `high`: every face that meets it,
  /// and others near it. The order depends on the tree alone.
  void nearBox(const Vec3& low, const Vec3& high, std::vector<int>& faces) const;

 private:
  struct Box {
    Vec3 low, high;
  };
  struct Node {
    Box box;
    /// Leaf: first entry of order_; inner: index of the right child (the left one follows its parent).
    int first = 0;
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
