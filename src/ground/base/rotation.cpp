#include "base/rotation.h"

#include <cmath>
#include <limits>

#include "base/reproducible.h"

namespace fissure {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace

Quat quaternionAbout(const Vec3& axis, double angle_rad) {
  const Vec3 xyz = reproducible::sin(0.5 * angle_rad) * axis;
  return {reproducible::cos(0.5 * angle_rad), xyz.x(), xyz.y(), xyz.z()};
}

// Rodrigues' formula.
Mat3 matrixAbout(const Vec3& axis, double angle_rad) {
  const double cosine = reproducible::cos(angle_rad);
  const Vec3 across = reproducible::sin(angle_rad) * axis, along = (1 - cosine) * axis;
  Mat3 matrix = along * axis.transpose();
  matrix.diagonal().array() += cosine;
  matrix(2, 1) += across.x();
  matrix(1, 2) -= across.x();
  matrix(0, 2) += across.y();
  matrix(2, 0) -= across.y();
  matrix(1, 0) += across.z();
  matrix(0, 1) -= across.z();
  return matrix;
}

Eigen::AngleAxisd axisAndAngle(const Quat& rotation) {
  double sine = rotation.vec().norm();
  if (sine < kEpsilon) sine = rotation.vec().stableNorm();  // its square may be too small for a double
  if (sine == 0) return {0, Vec3::UnitX()};
  const double angle_rad = 2 * reproducible::atan2(sine, std::abs(rotation.w()));
  return {angle_rad, rotation.vec() / (rotation.w() < 0 ? -sine : sine)};
}

Quat slerp(const Quat& from, double share, const Quat& to) {
  const double dot = from.dot(to), cosine = std::abs(dot);
  double share_from = 1 - share, share_to = share;
  if (cosine < 1 - kEpsilon) {  // else they are parallel, and the sine is 0
    const double angle_rad = reproducible::acos(cosine), sine = reproducible::sin(angle_rad);
    share_from = reproducible::sin((1 - share) * angle_rad) / sine;
    share_to = reproducible::sin(share * angle_rad) / sine;
  }
  return Quat(share_from * from.coeffs() + (dot < 0 ? -share_to : share_to) * to.coeffs());
}

}  // namespace fissure
