#pragma once

#include "base/geometry.h"

namespace fissure {

// Rotations whose bits are the same on every x86-64 processor. Eigen's own call sine and arc cosine of the C
// library; these do the same arithmetic with those of base/reproducible.h.

/// A turn about an axis of length 1, counter-clockwise seen from its tip.
Quat quaternionAbout(const Vec3& axis, double angle_rad);
Mat3 matrixAbout(const Vec3& axis, double angle_rad);

/// Axis and angle (0 to pi rad) of a rotation; of none the x axis and 0.
Eigen::AngleAxisd axisAndAngle(const Quat& rotation);

/// The shortest way between two orientations at constant angular velocity (Shoemake 1985); share: 0..1.
Quat slerp(const Quat& from, double share, const Quat& to);

}  // namespace fissure
