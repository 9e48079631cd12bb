// What a mesh's worst tetrahedra cost, before anything runs.
#include "elastic/stiff_elements.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "block_mesh.h"
#include "elastic/elastic_tissue.h"

namespace fissure::stiff_elements_test {

namespace {

const ElasticMaterial kTissue = {.youngs_modulus_Pa = 1e4, .poissons_ratio = 0.4, .density_kg_m3 = 1000};

double criticalStep_s(const TetrahedralMesh& mesh) {
  return ElasticTissue(mesh, {{kTissue}, {}}, {}, 0, Vec3::Zero()).criticalStep_s();
}

double criticalStepOfOthers_s(const TetrahedralMesh& mesh) {
  const ElementMaterials materials = {{kTissue}, {}};
  return ElasticTissue(mesh, softened(materials, mesh, stiffestElements(mesh, materials)), {}, 0,
                       Vec3::Zero())
      .criticalStep_s();
}

Vec3 centroidOf(const TetrahedralMesh& mesh, int element) {
  Vec3 sum_m = Vec3::Zero();
  for (const int v : mesh.tetrahedra[static_cast<std::size_t>(element)])
    sum_m += mesh.vertices_m[static_cast<std::size_t>(v)];
  return sum_m / 4;
}

/// A vertex inside moved close to a side of its tetrahedra makes a few slivers: they are found, and without
/// them the mesh allows what it did before.
TEST(StiffElements, AreTheSliversWithoutWhichTheLimitIsThatOfASoundMesh) {
  const BlockMesh block = makeBlock({.cells = {8, 8, 8}, .split = CellSplit::six});
  TetrahedralMesh box = block.mesh;
  const double sound_s = criticalStep_s(box);
  const auto moved = static_cast<std::size_t>(
      block.where([](const Vec3& v) { return (v - Vec3(0.02, 0.02, 0.02)).norm() < 1e-3; }).at(0));
  const Vec3 from_m = box.vertices_m[moved];
  box.vertices_m[moved] += Vec3(0.0048, 0.0002, 0.0001);
  const std::vector<int> stiffest = stiffestElements(box, {{kTissue}, {}});
  ASSERT_EQ(stiffest.size(), (box.tetrahedra.size() + 99) / 100);
  EXPECT_LT((centroidOf(box, stiffest.front()) - from_m).norm(), 0.006);
  EXPECT_LT(criticalStep_s(box), 0.5 * sound_s);
  EXPECT_GT(criticalStepOfOthers_s(box), 0.9 * sound_s);
}

TEST(StiffElements, GainLittleOnARegularMesh) {
  const TetrahedralMesh box = makeBlock({.cells = {5, 5, 5}, .split = CellSplit::six}).mesh;
  EXPECT_EQ(stiffestElements(box, {{kTissue}, {}}).size(), 8u);
  EXPECT_LT(criticalStepOfOthers_s(box), 1.3 * criticalStep_s(box));
}

TEST(StiffElements, AreThoseOfTheStiffRegion) {
  const TetrahedralMesh box = makeBlock({.cells = {5, 5, 5}, .split = CellSplit::six}).mesh;
  ElasticMaterial vessel = kTissue;
  vessel.youngs_modulus_Pa *= 100;
  std::vector<int> regions(box.tetrahedra.size(), 0);
  for (std::size_t t = 300; t < 308; ++t) regions[t] = 1;
  std::vector<int> stiffest = stiffestElements(box, {{kTissue, vessel}, regions});
  std::sort(stiffest.begin(), stiffest.end());
  EXPECT_EQ(stiffest, (std::vector{300, 301, 302, 303, 304, 305, 306, 307}));
}

}  // namespace

}  // namespace fissure::stiff_elements_test
