// A block without loads: what must not happen to it, and what does to a crushed one.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "block_mesh.h"
#include "tissue_probe.h"

namespace fissure {

namespace {

// Turned by 2 rad and moved.
TEST(RigidMotion, RotationGivesNoForce) {
  const BlockMesh block = makeBlock({.cells = {3, 4, 2}, .irregularity = 0.4});
  const Mat3 turn = Eigen::AngleAxisd(2, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const MaterialModel model : kModels)
    for (const double ratio : {0.0, 0.3, 0.49, 0.4999}) {
      ElasticTissue tissue(block.mesh, {model, 1e4, ratio, 1000}, {}, block.surface_vertices, Vec3::Zero());
      for (Vec3& position_m : tissue.positions_m()) position_m = turn * position_m + Vec3(1, 2, 3);
      // A strain of 1e-3 gives forces of 1e-3 E times the area of a cell, some 1e-3 N.
      for (const Vec3& force_N : internalForces_N(tissue)) EXPECT_LT(force_N.norm(), 2e-10) << ratio;
    }
}

// Vibrating, viscous, spinning and flying, at strains that are not small.
TEST(RigidMotion, MomentumAndAngularMomentumAreConserved) {
  const BlockMesh block = makeBlock({.cells = {3, 3, 3}, .irregularity = 0.4});
  for (const MaterialModel model : kModels)
    for (const double ratio : {0.3, 0.48}) {
      ElasticTissue tissue(block.mesh, {model, 1e4, ratio, 1000, 2}, {}, block.surface_vertices,
                           Vec3::Zero());
      Random random;
      for (std::size_t v = 0; v < tissue.velocities_m_s().size(); ++v)
        tissue.velocities_m_s()[v] =
            Vec3(1, 0, 2) + Vec3(3, 20, -5).cross(block.mesh.vertices_m[v]) + random.vector();
      const auto momenta = [&] {
        std::pair<Vec3, Vec3> sums = {Vec3::Zero(), Vec3::Zero()};
        for (std::size_t v = 0; v < tissue.velocities_m_s().size(); ++v) {
          const Vec3 momentum = tissue.masses_kg()[v] * tissue.velocities_m_s()[v];
          sums.first += momentum;
          sums.second += tissue.positions_m()[v].cross(momentum);
        }
        return sums;
      };
      const auto before = momenta();
      for (int step = 0; step < 200; ++step) {
        const int substeps = tissue.substepsFor(1e-3);
        for (int i = 0; i < substeps; ++i) tissue.advance(1e-3 / substeps);
      }
      const auto after = momenta();
      EXPECT_LT((after.first - before.first).norm(), 1e-12 * before.first.norm());
      EXPECT_LT((after.second - before.second).norm(), 1e-11 * before.second.norm());
      EXPECT_GT(tissue.energies().viscous_loss_J, 1e-4);
      EXPECT_TRUE(tissue.finite());
    }
}

/// Largest relative difference of an edge from its length at rest.
double distortion(const TetrahedralMesh& rest, std::span<const Vec3> positions_m) {
  double largest = 0;
  for (const Tetrahedron& corners : rest.tetrahedra)
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) {
        const double rest_m = (rest.vertices_m[corners[a]] - rest.vertices_m[corners[b]]).norm();
        const double now_m = (positions_m[corners[a]] - positions_m[corners[b]]).norm();
        largest = std::max(largest, std::abs(now_m / rest_m - 1));
      }
  return largest;
}

void settle(ElasticTissue& tissue, int steps) {
  for (int step = 0; step < steps; ++step) {
    const int substeps = tissue.substepsFor(1e-3);
    for (int i = 0; i < substeps; ++i) tissue.advance(1e-3 / substeps);
  }
}

/// Laws that drive inverted elements back.
constexpr MaterialModel kRecovering[] = {MaterialModel::neo_hookean, MaterialModel::linear_corotated};

// One tetrahedron, 10 % of its size, or with one corner mirrored at the others: it finds its shape again.
TEST(Recovery, OfAnElementThatIsCrushedOrInverted) {
  const TetrahedralMesh rest = {{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0.003, 0.002, 0.012}},
                                {{0, 1, 2, 3}}};
  for (const MaterialModel model : kRecovering)
    for (const double ratio : {0.0, 0.3, 0.45, 0.49, 0.4999}) {
      for (const bool inverted : {false, true}) {
        ElasticTissue tissue(rest, {model, 1e4, ratio, 1000, 1}, {}, 4, Vec3::Zero());
        if (inverted)
          tissue.positions_m()[3].z() *= -1;
        else
          for (Vec3& position_m : tissue.positions_m()) position_m *= 0.1;
        EXPECT_EQ(tissue.invertedElements(), inverted ? 1 : 0);
        settle(tissue, 1000);
        EXPECT_EQ(tissue.invertedElements(), 0);
        EXPECT_LT(distortion(rest, tissue.positions_m()), 1e-3)
            << static_cast<int>(model) << " " << ratio << " " << inverted;
      }
    }
}

// A vertex of a block pushed through its neighbours.
TEST(Recovery, OfABlockWithAVertexPushedThrough) {
  const BlockMesh block = makeBlock({.cells = {2, 2, 2}, .irregularity = 0.2});
  for (const MaterialModel model : kRecovering) {
    ElasticTissue tissue(block.mesh, {model, 1e4, 0.4, 1000, 2}, {}, block.surface_vertices, Vec3::Zero());
    tissue.positions_m().back() += Vec3(0.018, 0.03, 0.01);
    EXPECT_GT(tissue.invertedElements(), 0);
    settle(tissue, 1000);
    EXPECT_EQ(tissue.invertedElements(), 0);
    EXPECT_LT(distortion(block.mesh, tissue.positions_m()), 1e-3);
  }
}

}  // namespace

}  // namespace fissure
