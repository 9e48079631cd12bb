#include "study/tradeoff_read.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fissure::tradeoff_read_test {

namespace {

/// A flat square of 1 m in the plane y = `height_m`, of 2 n^2 triangles.
TissueShape square(int n, const std::vector<double>& heights_m, double step_s = 0.1) {
  TissueShape shape;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + 1, c = a + n + 1, d = c + 1;
      shape.faces.push_back({a, b, c});
      shape.faces.push_back({b, d, c});
    }
  for (std::size_t s = 0; s < heights_m.size(); ++s) {
    shape.time_s.push_back(static_cast<double>(s) * step_s);
    std::vector<Vec3>& vertices = shape.vertices_m.emplace_back();
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        vertices.emplace_back(static_cast<double>(i) / n, heights_m[s], static_cast<double>(j) / n);
  }
  return shape;
}

}  // namespace

TEST(ShapeError, IsTheDistanceOfSurfacesOfAnyMesh) {
  const CurveError same = shapeErrorOf(square(2, {0, 0.1}), square(8, {0, 0.1}));
  EXPECT_NEAR(same.rms, 0, 1e-15);
  const CurveError off = shapeErrorOf(square(2, {0, 0.1}), square(8, {0, 0.13}));
  EXPECT_NEAR(off.rms, 0.03 / std::sqrt(2), 1e-12) << "of two snapshots one is off by 0.03";
  EXPECT_NEAR(off.worst, 0.03, 1e-12);
  EXPECT_NEAR(off.peak, 0.03, 1e-12);
}

TEST(ShapeError, ASheetThatSlidesAlongItselfIsTheSameWithinItsEdges) {
  TissueShape slid = square(4, {0});
  for (Vec3& vertex : slid.vertices_m[0]) vertex.x() *= 2;
  EXPECT_NEAR(shapeErrorOf(slid, square(4, {0})).worst, 0, 1e-15);
}

TEST(ShapeError, SnapshotsBetweenAreInterpolated) {
  const TissueShape run = square(2, {0, 0.2, 0.4}, 0.2);  // at 0, 0.2, 0.4 s: height = time
  const TissueShape reference = square(2, {0, 0.1, 0.2, 0.3, 0.4}, 0.1);
  EXPECT_NEAR(shapeErrorOf(run, reference).worst, 0, 1e-12);
}

TEST(ShapeError, WhatIsMissingIsNoError) {
  const TissueShape reference = square(2, {0, 0.1, 0.2, 0.3});
  EXPECT_TRUE(std::isnan(shapeErrorOf({}, reference).rms));
  EXPECT_TRUE(std::isnan(shapeErrorOf(reference, {}).rms));
  EXPECT_TRUE(std::isnan(shapeErrorOf(square(2, {0, 0.1}), reference).rms)) << "it ended half way";
  TissueShape broken = reference;
  broken.vertices_m[1][3].y() = std::nan("");
  EXPECT_TRUE(std::isnan(shapeErrorOf(broken, reference).rms));
  EXPECT_TRUE(std::isnan(shapeErrorOf(reference, broken).rms));
  EXPECT_TRUE(std::isnan(largestDisplacement_m(broken)));
  EXPECT_NEAR(largestDisplacement_m(reference), 0.3, 1e-12);
}

}  // namespace fissure::tradeoff_read_test
