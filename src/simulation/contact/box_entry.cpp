#include "contact/box_entry.h"

#include <algorithm>

namespace fissure {

bool boxHolds(const Vec3& half_m, const Vec3& point_m) {
  return (point_m.cwiseAbs().array() < half_m.array()).all();
}

int boxEntryFace(const Vec3& half_m, const Vec3& from_m, const Vec3& to_m) {
  double enter = 0, leave = 1;
  int face = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = to_m[axis] - from_m[axis];
    for (const double sign : {1.0, -1.0}) {
      const double outside = sign * from_m[axis] - half_m[axis];  // > 0: in front of this face
      const double approach = -sign * way;
      if (outside >= 0) {
        if (approach <= 0) return -1;
        const double at = outside / approach;
        if (at >= enter) {
          enter = at;
          face = 2 * axis + (sign > 0 ? 0 : 1);
        }
      } else if (approach < 0) {
        leave = std::min(leave, outside / approach);
      }
    }
  }
  return enter <= leave ? face : -1;
}

}  // namespace fissure
