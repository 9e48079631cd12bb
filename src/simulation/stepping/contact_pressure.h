#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// The normal stress of contacts on a surface: at each vertex the force of its contacts along the surface's
/// inward normal there, over a third of the area of its triangles, in their present shape.
class ContactPressure {
 public:
  explicit ContactPressure(std::vector<Face> faces) : faces_(std::move(faces)) {}

  /// impulses_N_s: one per vertex, what contacts gave it in `step_s`; positions_m: of the same vertices.
  /// Fills pressures_Pa, one each: positive where tissue is pressed, 0 without contact. Allocates nothing
  /// once the arrays are as large.
  void find(std::span<const Vec3> impulses_N_s, double step_s, std::span<const Vec3> positions_m,
            std::vector<double>& pressures_Pa);

 private:
  std::vector<Face> faces_;
  std::vector<Vec3> areas_m2_;  ///< per vertex: outward, a third of its triangles'
};

}  // namespace fissure
