#include "mesh/lobes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "defect_lines.h"
#include "mesh/check.h"

namespace fissure::lobes_test {

namespace {

const std::vector<LobesShape>& shapes() {
  static const std::vector<LobesShape> all = {
      {},
      {.size_m = {0.08, 0.04, 0.08}, .slit_depth_m = 0.028, .slit_width_m = 0.003, .edge_m = 0.01},
      {.size_m = {0.1, 0.02, 0.05}, .slit_depth_m = 0.019, .slit_width_m = 0.02, .edge_m = 0.004},
      {.size_m = {0.05, 0.06, 0.09}, .slit_depth_m = 0.01, .slit_width_m = 1e-5, .edge_m = 0.2}};
  return all;
}

using Corner = std::tuple<double, double, double>;
/// The triangles by their corners' places, each starting at its least one, as a mirror at x = 0 (x_sign) and
/// z = 0 (z_sign) shows them.
std::multiset<std::array<Corner, 3>> triangles(const TriangleMesh& mesh, double x_sign, double z_sign) {
  std::multiset<std::array<Corner, 3>> all;
  for (const Face& face : mesh.faces) {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& at = mesh.vertices_m[static_cast<std::size_t>(face[k])];
      corners[k] = {x_sign * at.x() + 0.0, at.y(), z_sign * at.z() + 0.0};
    }
    if (x_sign * z_sign < 0) std::swap(corners[1], corners[2]);  // a mirror turns triangles round
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

TEST(Lobes, AreClosedOutwardAndWithoutSlivers) {
  for (const LobesShape& shape : shapes()) {
    const TriangleMesh mesh = makeLobes(shape);
    EXPECT_TRUE(inspectSurface(mesh).empty()) << inspectSurface(mesh).front().text;
    EXPECT_EQ(static_cast<double>(mesh.faces.size()), shape.triangles());
    EXPECT_EQ(2 * mesh.vertices_m.size(), mesh.faces.size() + 4) << "like a ball: no hole, no handle";
  }
}

// Where a quotient is rounded up, the floor of the slit must not stand open by it.
TEST(Lobes, MeetOnTheFloorOfTheSlitWhateverTheirCells) {
  for (const double height_m : {0.04, 0.05, 0.061}) {
    for (const double depth_m : {0.028, 0.03}) {
      for (int cells = 1; cells <= 14; ++cells) {
        const LobesShape shape{.size_m = Vec3(0.08, height_m, 0.08),
                               .slit_depth_m = depth_m,
                               .slit_width_m = 0.003,
                               .edge_m = (height_m - depth_m) / cells * (1 + 1e-12)};
        if (shape.triangles() > 20000) continue;
        EXPECT_EQ(findDefects(makeLobes(shape)), std::vector<std::string>{})
            << height_m << ", " << depth_m << ", " << cells << " cells";
      }
    }
  }
}

TEST(Lobes, AreTheirOwnMirrorImagesToTheLastBit) {
  for (const LobesShape& shape : shapes()) {
    const TriangleMesh mesh = makeLobes(shape);
    EXPECT_EQ(triangles(mesh, 1, 1), triangles(mesh, -1, 1));
    EXPECT_EQ(triangles(mesh, 1, 1), triangles(mesh, 1, -1));
  }
}

TEST(Lobes, HaveTheirSizeAndTheirSlit) {
  for (const LobesShape& shape : shapes()) {
    const TriangleMesh mesh = makeLobes(shape);
    Vec3 low = Vec3::Constant(1), high = Vec3::Constant(-1);
    double floor_m = 0, rim_m = 1;
    for (const Vec3& at : mesh.vertices_m) {
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
      if (at.z() != 0) continue;
      if (at.x() == 0) floor_m = std::max(floor_m, at.y());  // the seam ends in the floor
      if (at.x() > 0 && at.y() > shape.size_m.y() - 1e-12) rim_m = std::min(rim_m, at.x());
    }
    EXPECT_NEAR((low - Vec3(-shape.size_m.x() / 2, 0, -shape.size_m.z() / 2)).norm(), 0, 1e-15);
    EXPECT_NEAR((high - Vec3(shape.size_m.x() / 2, shape.size_m.y(), shape.size_m.z() / 2)).norm(), 0, 1e-15);
    EXPECT_NEAR(floor_m, shape.size_m.y() - shape.slit_depth_m, 1e-15);
    EXPECT_NEAR(rim_m, shape.slit_width_m / 2, 1e-15);
  }
}

// Half an ellipsoid but for what the slit takes and what flat triangles cut off.
TEST(Lobes, FineOnesEncloseHalfAnEllipsoid) {
  const LobesShape shape{
      .size_m = {0.08, 0.04, 0.06}, .slit_depth_m = 0.02, .slit_width_m = 1e-5, .edge_m = 0.001};
  const double half_ellipsoid_m3 = 2.0 / 3.0 * 3.141592653589793 * 0.04 * 0.04 * 0.03;
  EXPECT_NEAR(signedVolume_m3(makeLobes(shape)) / half_ellipsoid_m3, 1, 0.002);
}

}  // namespace
}  // namespace fissure::lobes_test
