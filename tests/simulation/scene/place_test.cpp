#include "scene/place.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mesh/check.h"
#include "mesh/primitives.h"

namespace fissure::place_test {

namespace {

BodySettings bodyOf(decltype(BodySettings::shape) shape) {
  return BodySettings{.name = "body", .shape = std::move(shape), .material = {}, .solver = {}};
}
TEST(PlaceBody, TurnsAboutTheShapesOriginThenMoves) {
  // One triangle; a quarter turn about z takes +x to +y. Moving first would give (-2, 1, 3) for the second
  // vertex.
  BodySettings body = bodyOf(TrianglesShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  body.position_m = {1, 2, 3};
  body.orientation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
  const TriangleMesh placed = placeBody(body);
  ASSERT_EQ(placed.vertices_m.size(), 3u);
  EXPECT_LT((placed.vertices_m[0] - Vec3(1, 2, 3)).norm(), 1e-15);
  EXPECT_LT((placed.vertices_m[1] - Vec3(1, 3, 3)).norm(), 1e-15);
  EXPECT_LT((placed.vertices_m[2] - Vec3(0, 2, 3)).norm(), 1e-15);
  EXPECT_EQ(placed.faces, (std::vector<Face>{{0, 1, 2}}));
}

TEST(PlaceBody, WithoutAPoseLeavesGivenTrianglesBitForBit) {
  const TriangleMesh box = makeBox({0.1, 0.2, 0.3});
  EXPECT_EQ(placeBody(bodyOf(TrianglesShape{box.vertices_m, box.faces})).vertices_m, box.vertices_m);
}

TEST(PlaceBody, KeepsSizeUnderARoundedQuaternion) {
  // 0.7071 twice has a norm of 0.99998; a rotation by it as it stands would change the box's size.
  BodySettings body = bodyOf(BoxShape{{1, 2, 3}});
  body.orientation = Quat(0.7071, 0, 0.7071, 0);
  EXPECT_NEAR(signedVolume_m3(placeBody(body)), 6.0, 1e-14);
}

TEST(PlaceBody, MakesTheShapeThatIsNamed) {
  BodySettings body = bodyOf(SphereShape{0.03, 2});
  body.position_m = {0, 0.03, 0};
  EXPECT_EQ(placeBody(body).faces, makeSphere(0.03, 2).faces);
  EXPECT_NEAR(placeBody(body).vertices_m[3].y(), 0, 1e-18);  // its south pole stands on the ground
  EXPECT_EQ(placeBody(bodyOf(BoxShape{{0.1, 0.2, 0.3}})).vertices_m, makeBox({0.1, 0.2, 0.3}).vertices_m);
}

}  // namespace
}  // namespace fissure::place_test
