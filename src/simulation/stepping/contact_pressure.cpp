#include "stepping/contact_pressure.h"

namespace fissure {

void ContactPressure::find(std::span<const Vec3> impulses_N_s, double step_s,
                           std::span<const Vec3> positions_m, std::vector<double>& pressures_Pa) {
  areas_m2_.assign(positions_m.size(), Vec3::Zero());
  for (const auto& [a, b, c] : faces_) {
    const Vec3 third_m2 = (positions_m[b] - positions_m[a]).cross(positions_m[c] - positions_m[a]) / 6;
    for (const int corner : {a, b, c}) areas_m2_[corner] += third_m2;
  }
  pressures_Pa.resize(positions_m.size());
  for (std::size_t v = 0; v < pressures_Pa.size(); ++v) {
    const double area_m2 = areas_m2_[v].norm();
    // Along the inward normal: over the area twice, once for the unit normal.
    pressures_Pa[v] = impulses_N_s[v] == Vec3::Zero() || area_m2 == 0
                          ? 0
                          : -impulses_N_s[v].dot(areas_m2_[v]) / (step_s * area_m2 * area_m2);
  }
}

}  // namespace fissure
