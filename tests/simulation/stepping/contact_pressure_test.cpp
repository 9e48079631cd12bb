#include "stepping/contact_pressure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "mesh/primitives.h"

namespace fissure::contact_pressure_test {

namespace {

/// Outward area vector of each vertex: a third of its triangles'.
std::vector<Vec3> areasOf(const TriangleMesh& mesh) {
  std::vector<Vec3> areas_m2(mesh.vertices_m.size(), Vec3::Zero());
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3 ab = mesh.vertices_m[b] - mesh.vertices_m[a], ac = mesh.vertices_m[c] - mesh.vertices_m[a];
    for (const int v : {a, b, c}) areas_m2[v] += ab.cross(ac) / 6;
  }
  return areas_m2;
}

TEST(ContactPressure, AUniformPressureIsFoundAtEveryVertex) {
  const TriangleMesh ball = makeSphere(0.03, 2);
  const double step_s = 0.002, pressure_Pa = 1234;
  std::vector<Vec3> impulses_N_s = areasOf(ball);
  for (Vec3& impulse : impulses_N_s) impulse *= -step_s * pressure_Pa;
  std::vector<double> found_Pa;
  ContactPressure(ball.faces).find(impulses_N_s, step_s, ball.vertices_m, found_Pa);
  ASSERT_EQ(found_Pa.size(), ball.vertices_m.size());
  for (const double one_Pa : found_Pa) EXPECT_NEAR(one_Pa, pressure_Pa, 1e-9 * pressure_Pa);
}

TEST(ContactPressure, PullsAreNegativeShearIsNoneAndFreeVerticesHaveZero) {
  const TriangleMesh box = makeBox(Vec3(0.02, 0.02, 0.02));
  const std::vector<Vec3> areas_m2 = areasOf(box);
  std::vector<Vec3> impulses_N_s(8, Vec3::Zero());
  impulses_N_s[0] = areas_m2[0];
  impulses_N_s[1] = areas_m2[1].unitOrthogonal();
  std::vector<double> found_Pa;
  ContactPressure(box.faces).find(impulses_N_s, 1, box.vertices_m, found_Pa);
  EXPECT_NEAR(found_Pa[0], -1, 1e-12);
  EXPECT_NEAR(found_Pa[1] * areas_m2[1].norm(), 0, 1e-12);
  for (int v = 2; v < 8; ++v) EXPECT_EQ(found_Pa[v], 0);
}

}  // namespace

}  // namespace fissure::contact_pressure_test
