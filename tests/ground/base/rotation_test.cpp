#include "base/rotation.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace fissure::rotation_test {

namespace {

constexpr double kPi = std::numbers::pi;

class Rotation : public testing::Test {
 protected:
  double between(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) / 9007199254740992.0;
  }
  Vec3 axis() { return Vec3(between(-1, 1), between(-1, 1), between(-1, 1)).normalized(); }
  Quat rotation() {
    return Quat(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
  }

 private:
  std::mt19937_64 random_{1};
};

// Eigen's own do the same arithmetic with the C library's functions: the last bits alone may differ.
TEST_F(Rotation, IsEigensUpToRounding) {
  for (int i = 0; i < 1000; ++i) {
    const Vec3 about = axis();
    const double angle_rad = between(-4, 4), share = between(0, 1);
    const Eigen::AngleAxisd turn(angle_rad, about);
    EXPECT_LT((quaternionAbout(about, angle_rad).coeffs() - Quat(turn).coeffs()).norm(), 1e-15);
    EXPECT_LT((matrixAbout(about, angle_rad) - turn.toRotationMatrix()).norm(), 2e-15);
    const Quat from = rotation(), to = rotation();
    EXPECT_LT((slerp(from, share, to).coeffs() - from.slerp(share, to).coeffs()).norm(), 1e-13);
    const Eigen::AngleAxisd found = axisAndAngle(from), expected(from);
    EXPECT_NEAR(found.angle(), expected.angle(), 1e-15);
    EXPECT_LT((found.axis() - expected.axis()).norm(), 1e-15);
  }
}

TEST_F(Rotation, AngleGoesToPiAndVanishesExactly) {
  EXPECT_EQ(axisAndAngle(Quat::Identity()).angle(), 0);
  EXPECT_EQ(axisAndAngle(Quat::Identity()).axis(), Vec3::UnitX());
  EXPECT_EQ(axisAndAngle(Quat(0, 0, 1, 0)).angle(), kPi);
  EXPECT_EQ(axisAndAngle(Quat(-1, 0, 0, 1e-200)).angle(), 2e-200);  // its square is 0
  EXPECT_EQ(axisAndAngle(Quat(-1, 0, 0, 1e-200)).axis(), -Vec3::UnitZ());
}

TEST_F(Rotation, SlerpGoesTheShorterWayAtConstantSpeed) {
  const Quat from = quaternionAbout(Vec3::UnitY(), 0.2), to = quaternionAbout(Vec3::UnitY(), 1.4);
  const Quat negative(-to.w(), -to.x(), -to.y(), -to.z());  // the same orientation
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    const Quat expected = quaternionAbout(Vec3::UnitY(), 0.2 + share * 1.2);
    EXPECT_LT((slerp(from, share, to).coeffs() - expected.coeffs()).norm(), 1e-15);
    EXPECT_LT((slerp(from, share, negative).coeffs() - expected.coeffs()).norm(), 1e-15);
  }
  EXPECT_EQ(slerp(from, 0.3, from).coeffs(), Eigen::Vector4d(0.7 * from.coeffs() + 0.3 * from.coeffs()));
}

}  // namespace
}  // namespace fissure::rotation_test
