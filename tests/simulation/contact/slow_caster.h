#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "contact/face_tree.h"

namespace fissure::test {

/// Rays against all triangles of a mesh one by one, the obvious way: where does the ray meet the plane, and
/// is that point on the inner side of the three edges. It knows where rounding could decide otherwise and
/// leaves that open.
class SlowCaster {
 public:
  /// Where a ray comes through a triangle, or within rounding of its border or of the ray's ends.
  struct Meeting {
    int face;
    double distance_m, cosine;
    bool within_ray;  ///< clearly between its ends
    bool certain;     ///< and clearly inside the triangle
  };

  explicit SlowCaster(const TriangleMesh& mesh);

  /// Nothing when `hit` is what a watertight caster may find for this ray, else what is wrong. Wherever the
  /// ray meets the inside of a triangle, or an edge or vertex all of whose triangles face the same way, it
  /// must be met; an edge on the silhouette and both ends of the ray may fall to either side of rounding.
  std::optional<std::string> complaint(const Vec3& origin_m, const Vec3& direction, double limit_m,
                                       const std::optional<SurfaceHit>& hit);

  long long undecided() const {
    return undecided_;
  }                                                 ///< rays nearly in the plane of a triangle that they meet
  long long on_edges() const { return on_edges_; }  ///< rays whose first meeting is an edge or vertex

 private:
  struct Plane {
    Vec3 normal, corner;
    std::array<Vec3, 3> corners, inwards;  ///< from edge i, unit, in the plane
  };
  /// Round a triangle, generously: rays that pass it by need no further look.
  struct Ball {
    Vec3 middle_m;
    double radius_squared;
  };
  bool meet(const Vec3& origin_m, const Vec3& direction, double limit_m);

  std::vector<Plane> planes_;
  std::vector<Ball> balls_;
  std::vector<Meeting> meetings_;
  long long undecided_ = 0, on_edges_ = 0;
};

}  // namespace fissure::test
