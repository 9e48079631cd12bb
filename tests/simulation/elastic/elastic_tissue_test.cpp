// What a tissue is not made of, and what its steps leave alone.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "allocations.h"
#include "tissue_probe.h"
#include "two_materials.h"

namespace fissure {

namespace {

constexpr ElasticMaterial kSoft = {MaterialModel::neo_hookean, 1e4, 0.4, 1000};

std::string refusal(const TetrahedralMesh& mesh, const ElasticMaterial& material,
                    const std::vector<int>& fixed = {}, int surface_vertices = 0) {
  try {
    ElasticTissue(mesh, material, fixed, surface_vertices, Vec3::Zero());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Refusal, OfMaterials) {
  const TetrahedralMesh mesh = makeBlock({}).mesh;
  const auto with = [&](auto field, double value) {
    ElasticMaterial material = kSoft;
    material.*field = value;
    return refusal(mesh, material);
  };
  EXPECT_EQ(refusal(mesh, kSoft), "accepted");
  EXPECT_EQ(with(&ElasticMaterial::youngs_modulus_Pa, 0),
            "elastic material: youngs_modulus_Pa is 0, expected a number above 0");
  EXPECT_EQ(with(&ElasticMaterial::poissons_ratio, 0.5),
            "elastic material: poissons_ratio is 0.5, expected a number from 0 and below 0.5");
  EXPECT_EQ(with(&ElasticMaterial::density_kg_m3, -1),
            "elastic material: density_kg_m3 is -1, expected a number above 0");
  EXPECT_EQ(with(&ElasticMaterial::viscosity_Pa_s, std::nan("")),
            "elastic material: viscosity_Pa_s is nan, expected a number from 0");
  EXPECT_EQ(with(&ElasticMaterial::mass_damping_1_s, std::numeric_limits<double>::infinity()),
            "elastic material: mass_damping_1_s is inf, expected a number from 0");
}

TEST(Refusal, OfMeshes) {
  const TetrahedralMesh good = makeBlock({.cells = {1, 1, 1}}).mesh;
  TetrahedralMesh mesh = good;
  std::swap(mesh.tetrahedra[1][0], mesh.tetrahedra[1][1]);
  EXPECT_EQ(refusal(mesh, kSoft), "elastic tissue: tetrahedron 1 has no positive volume");
  mesh = good;
  mesh.tetrahedra[2][3] = 8;
  EXPECT_EQ(refusal(mesh, kSoft), "elastic tissue: tetrahedron 2 has a corner that is no vertex");
  mesh = good;
  mesh.vertices_m.push_back(Vec3::Zero());
  EXPECT_EQ(refusal(mesh, kSoft), "elastic tissue: vertex 8 belongs to no tetrahedron");
  mesh = good;
  mesh.vertices_m[3].y() = std::nan("");
  EXPECT_EQ(refusal(mesh, kSoft), "elastic tissue: vertex 3 is not finite");
  EXPECT_EQ(refusal({good.vertices_m, {}}, kSoft), "elastic tissue: it has no tetrahedra");
  EXPECT_EQ(refusal(good, kSoft, {0, 8}), "elastic tissue: fixed vertex 8 is none of its 8");
  EXPECT_EQ(refusal(good, kSoft, {}, 9), "elastic tissue: 9 surface vertices of 8");
}

TEST(Tissue, TellsThatNumbersAreNotFinite) {
  const BlockMesh block = makeBlock({});
  ElasticTissue tissue(block.mesh, kSoft, {}, block.surface_vertices, Vec3::Zero());
  EXPECT_TRUE(tissue.finite());
  tissue.velocities_m_s()[3].x() = std::nan("");
  EXPECT_FALSE(tissue.finite());
  tissue.advance(1e-4);
  EXPECT_FALSE(tissue.finite());
  EXPECT_GE(tissue.substepsFor(1e-3), 1);
}

TEST(Tissue, FixedVerticesStay) {
  const BlockMesh block = makeBlock({});
  const auto held = block.where([](const Vec3& p) { return p.z() == 0; });
  ElasticTissue tissue(block.mesh, kSoft, held, block.surface_vertices, {0, 0, -9.81});
  const std::vector<Vec3> motion_m(static_cast<std::size_t>(block.surface_vertices), Vec3(1e-5, 0, 0));
  for (int i = 0; i < 10; ++i) {
    tissue.advance(1e-4);
    tissue.addMotion(motion_m, 1e-4);
  }
  for (const int v : held) {
    EXPECT_EQ(tissue.positions_m()[v], block.mesh.vertices_m[v]);
    EXPECT_EQ(tissue.velocities_m_s()[v], Vec3::Zero());
    EXPECT_GT(tissue.masses_kg()[v], 0);
  }
  double mass_kg = 0;
  for (const double vertex_kg : tissue.masses_kg()) mass_kg += vertex_kg;
  EXPECT_NEAR(mass_kg, 0.064, 1e-12);
}

TEST(Tissue, WholeTissueFixedNeedsOneSubstep) {
  const BlockMesh block = makeBlock({.cells = {1, 1, 1}});
  ElasticTissue tissue(block.mesh, kSoft, block.where([](const Vec3&) { return true; }), 0, {0, 0, -9.81});
  EXPECT_EQ(tissue.substepsFor(1), 1);
  tissue.advance(1);
  EXPECT_EQ(tissue.energies().kinetic_J, 0);
}

TEST(Tissue, StepsAllocateNothing) {
  const BlockMesh block = makeBlock({.cells = {3, 3, 3}});
  const std::vector<Vec3> motion_m(static_cast<std::size_t>(block.surface_vertices), Vec3(0, 0, -1e-6));
  for (const MaterialModel model : kModels) {
    const ElementMaterials materials =
        twoMaterials(block.mesh, {model, 1e4, 0.49, 1000, 1, 1}, {model, 1e5, 0.48, 1000, 0, 1},
                     [](const Vec3& p) { return p.z() > 0.02; });
    ElasticTissue tissue(block.mesh, materials, {}, block.surface_vertices, Vec3::Zero());
    const long long before = bench::allocations();
    for (int i = 0; i < 5; ++i) {
      tissue.advance(1e-3 / tissue.substepsFor(1e-3));
      tissue.addMotion(motion_m, 1e-4);
      tissue.energies();
      EXPECT_TRUE(tissue.finite() && tissue.invertedElements() == 0);
    }
    EXPECT_EQ(bench::allocations(), before);
  }
}

}  // namespace

}  // namespace fissure
