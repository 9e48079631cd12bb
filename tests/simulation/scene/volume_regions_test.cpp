// Which tetrahedra of a body belong to which of its regions.
#include "scene/volume_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/error.h"
#include "mesh/tetrahedra.h"
#include "scene/place.h"

namespace fissure::volume_regions_test {

namespace {

/// A box of 8 x 4 x 4 cells of 10 mm, which is turned and moved.
BodySettings boxWith(std::vector<ElasticRegion> regions) {
  BodySettings body;
  body.name = "liver";
  body.shape = BoxShape{.size_m = {0.08, 0.04, 0.04}, .cells = {8, 4, 4}};
  body.position_m = {1, 2, 3};
  body.orientation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
  body.model = BodyModel::elastic;
  body.elastic.regions = std::move(regions);
  return body;
}

long long count(const std::vector<int>& regions, int number) {
  return std::count(regions.begin(), regions.end(), number);
}

TEST(VolumeRegions, AreWhereTheirCentroidsAreInTheShapesFrame) {
  const auto half = ElasticRegion{.name = "half", .box = BoxRegion{{0, -1, -1}, {1, 1, 1}}};
  const SceneVolume volume = placeVolume(boxWith({half}));
  const TetrahedralMesh in_shape = makeBoxTetrahedra({0.08, 0.04, 0.04}, {8, 4, 4});
  ASSERT_EQ(volume.regions.size(), in_shape.tetrahedra.size());
  for (std::size_t t = 0; t < volume.regions.size(); ++t) {
    double sum_m = 0;
    for (const int corner : in_shape.tetrahedra[t]) sum_m += in_shape.vertices_m[corner].x();
    EXPECT_EQ(volume.regions[t], sum_m > 0 ? 1 : 0);
  }
  EXPECT_TRUE(placeVolume(boxWith({})).regions.empty());
}

TEST(VolumeRegions, ACapsuleHoldsWhatIsNearItsLine) {
  const CapsuleRegion vessel{{-0.02, 0, 0}, {0.02, 0, 0}, 0.012};
  const std::vector<int> regions = placeVolume(boxWith({{.name = "vessel", .capsule = vessel}})).regions;
  const TetrahedralMesh in_shape = makeBoxTetrahedra({0.08, 0.04, 0.04}, {8, 4, 4});
  for (std::size_t t = 0; t < regions.size(); ++t) {
    Vec3 centroid_m = Vec3::Zero();
    for (const int corner : in_shape.tetrahedra[t]) centroid_m += in_shape.vertices_m[corner] / 4;
    double nearest_m = 1;
    for (int i = 0; i <= 4000; ++i)
      nearest_m = std::min(nearest_m, (centroid_m - Vec3(-0.02 + 1e-5 * i, 0, 0)).norm());
    EXPECT_EQ(regions[t], nearest_m <= 0.012 ? 1 : 0);
  }
  EXPECT_GT(count(regions, 1), 50);
  // Both ends in one point: a ball.
  const CapsuleRegion ball{{0, 0, 0}, {0, 0, 0}, 0.02};
  EXPECT_TRUE(ball.holds({0.01, 0.01, 0.01}));
  EXPECT_FALSE(ball.holds({0.02, 0.01, 0}));
}

TEST(VolumeRegions, LaterOnesWin) {
  const ElasticRegion all{.name = "all", .box = BoxRegion{{-1, -1, -1}, {1, 1, 1}}};
  const ElasticRegion half{.name = "half", .box = BoxRegion{{0, -1, -1}, {1, 1, 1}}};
  const std::vector<int> regions = placeVolume(boxWith({all, half})).regions;
  EXPECT_EQ(count(regions, 1), 384);
  EXPECT_EQ(count(regions, 2), 384);
}

std::string refusal(const BodySettings& body) {
  try {
    placeVolume(body);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(VolumeRegions, WithoutATetrahedronOrATagAreRefused) {
  const ElasticRegion all{.name = "all", .box = BoxRegion{{-1, -1, -1}, {1, 1, 1}}};
  const ElasticRegion far{.name = "far", .box = BoxRegion{{1, 1, 1}, {2, 2, 2}}};
  EXPECT_EQ(
      refusal(boxWith({all, far})),
      "bodies.liver.elastic.regions.far holds no tetrahedron that no later region has, expected at least "
      "one");
  ElasticRegion again = all;
  again.name = "again";
  EXPECT_EQ(refusal(boxWith({all, again})).find("bodies.liver.elastic.regions.all holds no"), 0u);
  EXPECT_EQ(
      refusal(boxWith({{.name = "part", .tag = 1}})),
      "bodies.liver.elastic.regions.part.tag: the tetrahedra of the body's shape have no tags, expected "
      "box or capsule");
}

TEST(VolumeRegions, HaveTheTagsOfAMesh) {
  TetrahedralMesh mesh = makeBoxTetrahedra({1, 1, 1}, {1, 1, 1});
  mesh.tags = {7, 7, 9, 7, 9, 8};
  const BodySettings body = boxWith({{.name = "nine", .tag = 9}, {.name = "eight", .tag = 8}});
  EXPECT_EQ(volumeRegions(body, mesh), (std::vector<int>{0, 0, 1, 0, 1, 2}));
}

}  // namespace

}  // namespace fissure::volume_regions_test
