#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Slopes at the samples, m/s, with which cubic Hermite interpolation is monotone wherever the samples are,
/// in each coordinate separately: the curve passes through every sample and stays between neighbouring ones.
/// Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980), 238: three-point differences, zero at extrema, shrunk
/// onto the circle of radius 3. `times_s` strictly increasing, as many as `positions_m`; a single sample has
/// slope zero.
std::vector<Vec3> monotoneSlopes(std::span<const double> times_s, std::span<const Vec3> positions_m);

/// Position on a cubic Hermite segment of duration `length_s` at the share `u` (0..1) of that duration,
/// metres.
Vec3 hermite(const Vec3& from_m, const Vec3& to_m, const Vec3& slope_from_m_s, const Vec3& slope_to_m_s,
             double length_s, double u);

}  // namespace fissure
