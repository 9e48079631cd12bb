#include "scene/fixed_vertices.h"

#include <gtest/gtest.h>

#include "scene/place.h"

namespace fissure::fixed_vertices_test {

namespace {

BodySettings cube() {
  BodySettings body;
  body.shape = BoxShape{Vec3(2, 2, 2)};
  body.position_m = Vec3(10, 1, 0);  // stands on y = 0
  return body;
}

int count(const BodySettings& body) {
  return static_cast<int>(fixedVertices(body, placeBody(body).vertices_m).size());
}

TEST(FixedVertices, AreThoseInTheirRegionsWhereTheBodyIsPlaced) {
  BodySettings body = cube();
  EXPECT_EQ(count(body), 0);
  body.fixed = {{.below_m = 0.0}};
  EXPECT_EQ(count(body), 4) << "the bound belongs to it";
  body.fixed = {{.below_m = -0.001}};
  EXPECT_EQ(count(body), 0);
  body.fixed = {{.below_m = 2.0}};
  EXPECT_EQ(count(body), 8);
  body.fixed = {{.box = BoxRegion{Vec3(9, -1, -1), Vec3(9, 3, 1)}}};
  EXPECT_EQ(count(body), 4) << "one side, bounds included";
  body.fixed[0].box = BoxRegion{Vec3(10.5, 1.5, 0.5), Vec3(12, 3, 2)};
  EXPECT_EQ(count(body), 1);
  body.orientation = Quat(Eigen::AngleAxisd(0.7853981633974483, Vec3::UnitY()));
  body.fixed[0].box = BoxRegion{Vec3(11.4, -1, -0.1), Vec3(11.5, 3, 0.1)};
  EXPECT_EQ(count(body), 2) << "an edge, turned";
}

TEST(FixedVertices, OfSeveralRegionsEachOnceInOrder) {
  BodySettings body = cube();
  body.fixed = {{.box = BoxRegion{Vec3(9, -1, -1), Vec3(9, 3, 1)}}, {.below_m = 0.5}};
  const TriangleMesh rest = placeBody(body);
  const std::vector<int> fixed = fixedVertices(body, rest.vertices_m);
  ASSERT_EQ(fixed.size(), 6u);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(fixed[i - 1], fixed[i]);
    }
    const Vec3& vertex = rest.vertices_m[fixed[i]];
    EXPECT_TRUE(vertex.x() < 9.5 || vertex.y() < 0.5);
  }
}

}  // namespace
}  // namespace fissure::fixed_vertices_test
