// Tissue of two materials: springs in series, forces that belong to its energy, the largest stable step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plain_elements.h"
#include "tissue_probe.h"
#include "two_materials.h"

namespace fissure::regions_test {

namespace {

constexpr double kSide_m = 0.04;

bool isBelow(const Vec3& p) {
  return p.z() < kSide_m / 2;
}

/// A block with irregular vertices inside, but for a plane at half its height.
BlockMesh layeredBlock(const std::array<int, 3>& cells) {
  BlockMesh block = makeBlock({.cells = cells, .size_m = {kSide_m, kSide_m, kSide_m}, .irregularity = 0.4});
  const double cell_m = kSide_m / cells[2];
  for (Vec3& vertex_m : block.mesh.vertices_m)
    if (std::abs(vertex_m.z() - kSide_m / 2) < 0.25 * cell_m) vertex_m.z() = kSide_m / 2;
  return block;
}

/// Stretches of two layers of the same height, held sideways, that bear the same stress.
struct InSeries {
  double lower = 1, upper = 1, stress_Pa = 0;
};

InSeries inSeries(const ElasticMaterial& upper, const ElasticMaterial& lower, double mean) {
  const auto stress_Pa = [](const ElasticMaterial& material, double stretch) {
    return plainStress(material, Vec3(1, 1, stretch).asDiagonal())(2, 2);
  };
  double low = 1, high = 2 * mean - 1;  // of the lower layer: from all of it above to all of it here
  for (int round = 0; round < 200; ++round) {
    const double middle = (low + high) / 2;
    const bool more = std::abs(stress_Pa(lower, middle)) < std::abs(stress_Pa(upper, 2 * mean - middle));
    (more ? low : high) = middle;
  }
  return {low, 2 * mean - low, stress_Pa(lower, low)};
}

// The interface comes to where two springs in series have it, and both bear their force. Linear corotated
// tissue that is held sideways is linear: the closed form is that of Hooke's law.
TEST(Regions, LayersAreSpringsInSeries) {
  const BlockMesh block = layeredBlock({2, 3, 6});
  const auto ends = block.where([](const Vec3& p) { return p.z() == 0 || p.z() == kSide_m; });
  for (const MaterialModel model : kModels)
    for (const auto& [upper_ratio, lower_ratio] :
         {std::pair{0.0, 0.0}, std::pair{0.3, 0.49}, std::pair{0.49, 0.3}, std::pair{0.49, 0.48}})
      for (const double mean : {0.97, 1.1}) {
        constexpr double kDamping_1_s = 300;
        const ElasticMaterial upper = {model, 1e4, upper_ratio, 1000, 0, kDamping_1_s};
        const ElasticMaterial lower = {model, 3e4, lower_ratio, 1500, 2, kDamping_1_s};
        ElasticTissue tissue(block.mesh, twoMaterials(block.mesh, upper, lower, isBelow), ends, 0,
                             Vec3::Zero());
        for (const int v : ends) tissue.positions_m()[v].z() *= mean;
        for (int step = 0; step < 500; ++step) {
          const int substeps = tissue.substepsFor(1e-3);
          for (int i = 0; i < substeps; ++i) {
            tissue.advance(1e-3 / substeps);
            for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v) {
              tissue.positions_m()[v].head<2>() = block.mesh.vertices_m[v].head<2>();
              tissue.velocities_m_s()[v].head<2>().setZero();
            }
          }
        }
        const InSeries expected = inSeries(upper, lower, mean);
        for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v) {
          const double z_m = block.mesh.vertices_m[v].z(), above_m = std::max(0.0, z_m - kSide_m / 2);
          EXPECT_NEAR(tissue.positions_m()[v].z(),
                      expected.lower * (z_m - above_m) + expected.upper * above_m, 1e-6 * kSide_m)
              << upper_ratio << " " << lower_ratio << " " << mean;
        }
        if (model == MaterialModel::linear_corotated) {
          const auto confined_Pa = [](const ElasticMaterial& material) {
            const LameConstants lame = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio);
            return lame.lambda_Pa + 2 * lame.mu_Pa;
          };
          const double a_Pa = confined_Pa(upper), b_Pa = confined_Pa(lower);
          EXPECT_NEAR(expected.stress_Pa, 2 * (mean - 1) * a_Pa * b_Pa / (a_Pa + b_Pa), 1e-6 * a_Pa);
        }
        const double area_m2 = kSide_m * kSide_m;
        // What is stored is the work of both springs; what the top is pulled with is the stress times its
        // area.
        double pull_N = 0;
        const std::vector<Vec3> forces_N = [&] {
          ElasticTissue free(block.mesh, twoMaterials(block.mesh, upper, lower, isBelow), {}, 0,
                             Vec3::Zero());
          std::copy(tissue.positions_m().begin(), tissue.positions_m().end(), free.positions_m().begin());
          return internalForces_N(free);
        }();
        for (const int v : ends)
          if (block.mesh.vertices_m[v].z() > 0) pull_N -= forces_N[v].z();
        EXPECT_NEAR(pull_N, expected.stress_Pa * area_m2, 1e-5 * std::abs(expected.stress_Pa * area_m2))
            << upper_ratio << " " << lower_ratio << " " << mean;
      }
}

/// Sums of the forces of `forces` at `positions_m` (three numbers a vertex, and one more).
std::vector<Vec3> forcesAt_N(ElementForces& forces, const std::vector<double>& positions_m) {
  forces.compute(positions_m.data(), nullptr);
  const ElementArrays arrays = forces.arrays();
  std::vector<Vec3> sums_N(static_cast<std::size_t>(arrays.vertices), Vec3::Zero());
  for (int v = 0; v < arrays.vertices; ++v)
    for (int slot = arrays.first_slots[v]; slot < arrays.first_slots[v + 1]; ++slot)
      sums_N[v] += Eigen::Map<const Vec3>(forces.forceSlots() + 4 * static_cast<std::size_t>(slot));
  return sums_N;
}

TEST(Regions, ForcesAreTheDerivativeOfTheEnergy) {
  const BlockMesh block = makeBlock({.cells = {3, 3, 3}, .irregularity = 0.4});
  Random random;
  for (const MaterialModel model : kModels)
    for (const auto& [one, other] : {std::pair{0.3, 0.49}, std::pair{0.49, 0.47}, std::pair{0.0, 0.45}})
      for (const double size_m : {1e-3, 3e-3, 2e-2}) {  // the last one turns elements inside out
        if (model == MaterialModel::linear_corotated && size_m > 1e-2) continue;  // has kinks there
        ElementForces forces(
            block.mesh, twoMaterials(block.mesh, {model, 1e4, one, 1000}, {model, 5e5, other, 1000}, isBelow),
            supportedInstructionSets().back());
        std::vector<double> positions_m;
        for (const Vec3& vertex_m : block.mesh.vertices_m) {
          const Vec3 there_m = vertex_m + size_m * random.vector();
          positions_m.insert(positions_m.end(), there_m.begin(), there_m.end());
        }
        positions_m.push_back(0);
        const std::vector<Vec3> forces_N = forcesAt_N(forces, positions_m);
        double largest_N = 0, worst_N = 0;
        for (std::size_t i = 0; i + 1 < positions_m.size(); ++i) {
          constexpr double kMove_m = 1e-7;
          const double before_m = positions_m[i];
          positions_m[i] = before_m + kMove_m;
          const double ahead_J = forces.storedEnergy_J(positions_m.data());
          positions_m[i] = before_m - kMove_m;
          const double behind_J = forces.storedEnergy_J(positions_m.data());
          positions_m[i] = before_m;
          const double force_N = forces_N[i / 3][static_cast<Eigen::Index>(i % 3)];
          largest_N = std::max(largest_N, std::abs(force_N));
          worst_N = std::max(worst_N, std::abs((behind_J - ahead_J) / (2 * kMove_m) - force_N));
        }
        EXPECT_LT(worst_N, 1e-6 * largest_N) << one << " " << other << " " << size_m;
      }
}

struct Moved {
  std::vector<Vec3> positions_m;
  ElasticEnergies energies;
  double critical_step_s = 0;  ///< at rest
};

Moved shaken(const BlockMesh& block, const ElementMaterials& materials) {
  ElasticTissue tissue(block.mesh, materials, block.where([](const Vec3& p) { return p.z() == 0; }), 0,
                       {0, 0, -9.81});
  const double critical_step_s = tissue.criticalStep_s();
  for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
    tissue.velocities_m_s()[v] = Vec3(0.5, 0, 0.2) * block.mesh.vertices_m[v].z() / kSide_m;
  for (int step = 0; step < 20; ++step) {
    tissue.substepsFor(1e-3);
    for (int i = 0; i < 10; ++i) tissue.advance(1e-4);
  }
  return {{tissue.positions_m().begin(), tissue.positions_m().end()}, tissue.energies(), critical_step_s};
}

// Regions of one material are none, to the last bit. A viscosity that nobody feels makes groups of their own,
// and the sums get another order.
TEST(Regions, OfTheSameMaterialChangeNothing) {
  const BlockMesh block = layeredBlock({3, 3, 4});
  for (const MaterialModel model : kModels)
    for (const double ratio : {0.3, 0.49}) {
      const ElasticMaterial material = {model, 1e4, ratio, 1000, 0, 5};
      const Moved plain = shaken(block, {{material}, {}});
      const Moved same = shaken(block, twoMaterials(block.mesh, material, material, isBelow));
      EXPECT_EQ(plain.positions_m, same.positions_m);
      EXPECT_EQ(plain.energies.stored_J, same.energies.stored_J);
      EXPECT_EQ(plain.critical_step_s, same.critical_step_s);
      if (ratio > VolumeSplit::kAveragedAbove) continue;  // each material has its own averages
      ElasticMaterial another = material;
      another.viscosity_Pa_s = 1e-300;
      const Moved other = shaken(block, twoMaterials(block.mesh, material, another, isBelow));
      for (std::size_t v = 0; v < plain.positions_m.size(); ++v)
        EXPECT_LT((plain.positions_m[v] - other.positions_m[v]).norm(), 1e-12 * kSide_m);
      EXPECT_NEAR(other.energies.stored_J, plain.energies.stored_J, 1e-12 * plain.energies.stored_J);
      EXPECT_NEAR(other.critical_step_s, plain.critical_step_s, 1e-9 * plain.critical_step_s);
    }
}

TEST(Regions, MassesAreThoseOfTheirDensities) {
  const BlockMesh block = layeredBlock({3, 3, 4});
  const ElasticMaterial light = {MaterialModel::neo_hookean, 1e4, 0.3, 500},
                        heavy = {MaterialModel::neo_hookean, 1e4, 0.3, 2000};
  const ElementMaterials materials = twoMaterials(block.mesh, light, heavy, isBelow);
  const ElasticTissue tissue(block.mesh, materials, {}, 0, Vec3::Zero());
  const DenseTissue dense(block.mesh, materials);
  double sum_kg = 0;
  for (std::size_t v = 0; v < tissue.masses_kg().size(); ++v) {
    EXPECT_NEAR(tissue.masses_kg()[v], dense.masses_kg[3 * static_cast<Eigen::Index>(v)], 1e-15);
    sum_kg += tissue.masses_kg()[v];
  }
  EXPECT_NEAR(sum_kg, 1250 * std::pow(kSide_m, 3), 1e-12);
}

// With h^2 K + 2 h C at most 4 M, by eigenvalues of dense matrices.
TEST(Regions, TheCriticalStepIsThatOfTheDenseMatrices) {
  const BlockMesh block = makeBlock({.cells = {3, 4, 4}, .irregularity = 0.4});
  const auto held = block.where([](const Vec3& p) { return p.z() == 0; });
  const auto inclusion = [](const Vec3& p) { return (p - Vec3(0.02, 0.02, 0.02)).norm() < 0.01; };
  for (const auto& [soft_ratio, stiff_ratio] :
       {std::pair{0.3, 0.3}, std::pair{0.3, 0.49}, std::pair{0.49, 0.3}, std::pair{0.49, 0.48}})
    for (const auto& [soft_Pa_s, stiff_Pa_s] :
         {std::pair{0.0, 0.0}, std::pair{1.0, 0.0}, std::pair{0.0, 5.0}, std::pair{20.0, 3.0}}) {
      const ElasticMaterial soft = {MaterialModel::neo_hookean, 5e3, soft_ratio, 1000, soft_Pa_s, 10};
      const ElasticMaterial stiff = {MaterialModel::neo_hookean, 6e5, stiff_ratio, 1100, stiff_Pa_s, 10};
      const ElementMaterials materials = twoMaterials(block.mesh, soft, stiff, inclusion);
      ASSERT_GT(std::count(materials.of_elements.begin(), materials.of_elements.end(), 1), 5);
      const ElasticTissue tissue(block.mesh, materials, held, 0, Vec3::Zero());
      const DenseTissue dense(block.mesh, materials);
      const double h = tissue.criticalStep_s();
      const double load = dense.largest(h * h * dense.stiffness + 2 * h * dense.damping, held) + 20 * h;
      EXPECT_NEAR(load, 4, 1e-3) << soft_ratio << " " << stiff_ratio << " " << soft_Pa_s << " " << stiff_Pa_s;

      for (const bool of_stiff : {false, true}) {
        ElementMaterials alone = materials;
        ElasticMaterial& nothing = alone.materials[of_stiff ? 0 : 1];
        nothing.youngs_modulus_Pa = nothing.viscosity_Pa_s = nothing.poissons_ratio = 0;
        const DenseTissue one(block.mesh, alone);
        const double alone_s = tissue.criticalStepOf_s(of_stiff ? stiff : soft);
        const double of_one =
            one.largest(alone_s * alone_s * one.stiffness + 2 * alone_s * one.damping, held);
        EXPECT_NEAR(of_one, 4, 1e-3);
      }
    }
}

// A soft layer that is stretched to 1.5 leaves the step to a stiff one that is not.
TEST(Regions, OnlyTheirOwnStretchShortensTheStep) {
  const BlockMesh block = layeredBlock({3, 3, 4});
  for (const MaterialModel model : kModels)
    for (const double viscosity : {0.0, 0.5}) {
      const ElasticMaterial soft = {model, 1e4, 0.4, 1000, viscosity};
      const ElasticMaterial stiff = {model, 1e6, 0.4, 1000, viscosity};
      for (const bool stretched_is_soft : {true, false}) {
        ElasticTissue tissue(block.mesh,
                             twoMaterials(block.mesh, stretched_is_soft ? soft : stiff,
                                          stretched_is_soft ? stiff : soft, isBelow),
                             {}, 0, Vec3::Zero());
        const double at_rest_s = tissue.criticalStep_s();
        for (Vec3& position_m : tissue.positions_m()) {
          const double above_m = std::max(0.0, position_m.z() - kSide_m / 2);
          position_m.z() += above_m;
          position_m.head<2>() *= 1 + 0.3 * above_m / (kSide_m / 2);
        }
        tissue.substepsFor(1e-3);
        const double share = tissue.criticalStep_s() / at_rest_s;
        if (stretched_is_soft) {
          EXPECT_GT(share, 0.9);
        } else if (model == MaterialModel::neo_hookean) {
          EXPECT_LT(share, 0.5);
        }
      }
    }
}

// Shaken hard, with different losses: all that is missing is booked.
TEST(Regions, LossesCloseTheBalance) {
  const BlockMesh block = makeBlock({.cells = {4, 4, 4}, .irregularity = 0.4});
  const auto held = block.where([](const Vec3& p) { return p.z() == 0; });
  for (const MaterialModel model : kModels)
    for (const double viscosity : {0.0, 3.0}) {
      const ElasticMaterial soft = {model, 1e4, 0.48, 1000, viscosity, 2};
      const ElasticMaterial stiff = {model, 1e5, 0.3, 1200, 0, 2};
      ElasticTissue tissue(block.mesh, twoMaterials(block.mesh, soft, stiff, isBelow), held, 0,
                           {0, 0, -9.81});
      for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
        tissue.velocities_m_s()[v] = Vec3(0.5, 0, 0.2) * block.mesh.vertices_m[v].z() / kSide_m;
      const int substeps = 4 * tissue.substepsFor(1e-3);
      tissue.advance(1e-3 / substeps);
      const double start_J = balance_J(tissue.energies());
      double largest_J = 0, worst_J = 0;
      for (int step = 0; step < 200; ++step) {
        for (int i = 0; i < substeps; ++i) tissue.advance(1e-3 / substeps);
        largest_J = std::max(largest_J, tissue.energies().kinetic_J);
        worst_J = std::max(worst_J, std::abs(balance_J(tissue.energies()) - start_J));
      }
      EXPECT_LT(worst_J, 0.0003 * largest_J);
      EXPECT_EQ(tissue.energies().viscous_loss_J > 0.1 * largest_J, viscosity > 0);
    }
}

// More than two, some without elements, and one that is only a few tetrahedra: forces are those of the plain
// loop over elements, each of its material.
TEST(Regions, ForcesAreSumsOfThoseOfEachMaterial) {
  const BlockMesh block = makeBlock({.cells = {3, 3, 3}, .irregularity = 0.4});
  for (const MaterialModel model : kModels) {
    ElementMaterials materials = {
        {{model, 1e4, 0.3, 1000}, {model, 7e4, 0.1, 1000}, {model, 1e6, 0.2, 1000}, {model, 5e3, 0.45, 1000}},
        {}};
    for (std::size_t e = 0; e < block.mesh.tetrahedra.size(); ++e)
      materials.of_elements.push_back(e == 17 ? 3 : e % 3 == 0 ? 1 : 0);
    ElasticTissue tissue(block.mesh, materials, {}, 0, Vec3::Zero());
    Random random;
    for (Vec3& position_m : tissue.positions_m()) position_m += 3e-3 * random.vector();
    std::vector<Vec3> expected_N(block.mesh.vertices_m.size(), Vec3::Zero());
    for (std::size_t m = 0; m < materials.materials.size(); ++m) {
      TetrahedralMesh part = {block.mesh.vertices_m, {}, {}};
      for (std::size_t e = 0; e < block.mesh.tetrahedra.size(); ++e)
        if (materials.of_elements[e] == static_cast<int>(m))
          part.tetrahedra.push_back(block.mesh.tetrahedra[e]);
      PlainElements plain(part, materials.materials[m]);
      std::copy(tissue.positions_m().begin(), tissue.positions_m().end(), plain.positions_m.begin());
      plain.computeForces();
      for (std::size_t v = 0; v < expected_N.size(); ++v) expected_N[v] += plain.forces_N[v];
    }
    const std::vector<Vec3> forces_N = internalForces_N(tissue);
    double largest_N = 0, difference_N = 0;
    for (std::size_t v = 0; v < forces_N.size(); ++v) {
      largest_N = std::max(largest_N, expected_N[v].norm());
      difference_N = std::max(difference_N, (forces_N[v] - expected_N[v]).norm());
    }
    EXPECT_LE(difference_N, 1e-9 * largest_N);
    EXPECT_THROW(tissue.criticalStepOf_s(materials.materials[2]), std::invalid_argument);
  }
}

TEST(Regions, WhatIsNoMaterialIsRefused) {
  const BlockMesh block = makeBlock({.cells = {1, 1, 1}});
  const ElasticMaterial good = {MaterialModel::neo_hookean, 1e4, 0.3, 1000};
  ElasticMaterial bad = good, other_law = good, other_damping = good;
  bad.youngs_modulus_Pa = -1;
  other_law.model = MaterialModel::linear_corotated;
  other_damping.mass_damping_1_s = 1;
  for (const ElementMaterials& materials :
       {ElementMaterials{{}, {}}, ElementMaterials{{good}, {0, 0}}, ElementMaterials{{good}, {0, 0, 0, 0, 1}},
        ElementMaterials{{good}, {0, 0, 0, 0, -1}}, ElementMaterials{{good, bad}, {0, 0, 0, 0, 1}},
        ElementMaterials{{good, other_law}, {0, 0, 0, 0, 1}},
        ElementMaterials{{good, other_damping}, {0, 0, 0, 0, 1}}})
    EXPECT_THROW(ElasticTissue(block.mesh, materials, {}, 0, Vec3::Zero()), std::invalid_argument);
  EXPECT_NO_THROW(ElasticTissue(block.mesh, {{good}, {0, 0, 0, 0, 0}}, {}, 0, Vec3::Zero()));
}

}  // namespace

}  // namespace fissure::regions_test
