#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// The normal stress of contacts on a surface: at each vertex the contact force along the surface's inward
/// normal over a third of the area of its triangles, in the present shape.
class ContactPressure {
 public:
  explicit ContactPressure(std::vector<Face> faces) : faces_(std::move(faces)) {}

  /// impulses_N_s: [vertex] impulse of contacts on it in `step_s`; positions_m: [vertex], both in the scene
  /// frame. Fills pressures_Pa ([vertex], pascals): positive in compression, 0 without contact. Allocates
  /// only to enlarge its arrays.
  void find(std::span<const Vec3> impulses_N_s, double step_s, std::span<const Vec3> positions_m,
            std::vector<double>& pressures_Pa);

 private:
  std::vector<Face> faces_;
  std::vector<Vec3> areas_m2_;  ///< [vertex] a third of the outward area vectors of its triangles
};

}  // namespace fissure
