// The balance of energies: what is stored is what forces are the derivative of, and losses are what is
// missing.
#include <gtest/gtest.h>

#include <cmath>

#include "block_mesh.h"
#include "tissue_probe.h"

namespace fissure {

namespace {

struct Vibration {
  double largest_J = 0;      ///< of the kinetic energy
  double worst_J = 0;        ///< distance of the balance from its start
  ElasticEnergies energies;  ///< at the end
};

/// A block held below, whose top starts sideways at 0.5 m/s: strains of up to 30 %.
Vibration vibrate(const ElasticMaterial& material, int steps_per_limit = 1) {
  const BlockMesh block = makeBlock({.cells = {4, 4, 4}, .irregularity = 0.4});
  const auto held = block.where([](const Vec3& p) { return p.z() == 0; });
  ElasticTissue tissue(block.mesh, material, held, block.surface_vertices, {0, 0, -9.81});
  for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
    tissue.velocities_m_s()[v] = Vec3(0.5, 0, 0.2) * block.mesh.vertices_m[v].z() / 0.04;
  Vibration result;
  const int substeps = steps_per_limit * 2 * tissue.substepsFor(1e-3);
  tissue.advance(1e-3 / substeps);
  const double start_J = balance_J(tissue.energies());
  for (int step = 0; step < 300; ++step) {
    for (int i = 0; i < substeps; ++i) tissue.advance(1e-3 / substeps);
    result.energies = tissue.energies();
    result.largest_J = std::max(result.largest_J, result.energies.kinetic_J);
    result.worst_J = std::max(result.worst_J, std::abs(balance_J(result.energies) - start_J));
  }
  return result;
}

TEST(Energy, WithoutLossNoneDrifts) {
  for (const MaterialModel model : kModels)
    for (const double ratio : {0.0, 0.3, 0.48}) {
      const Vibration coarse = vibrate({model, 1e4, ratio, 1000});
      const Vibration fine = vibrate({model, 1e4, ratio, 1000}, 4);
      EXPECT_LT(coarse.worst_J, 0.001 * coarse.largest_J) << ratio;
      EXPECT_LT(fine.worst_J, 0.0001 * fine.largest_J) << ratio;
    }
}

TEST(Energy, LossesCloseTheBalance) {
  for (const MaterialModel model : kModels)
    for (const double ratio : {0.3, 0.48}) {
      for (const auto& [viscosity, damping] :
           {std::pair{3.0, 0.0}, std::pair{0.0, 20.0}, std::pair{3.0, 20.0}}) {
        const Vibration vibration = vibrate({model, 1e4, ratio, 1000, viscosity, damping});
        EXPECT_LT(vibration.worst_J, 0.001 * vibration.largest_J);
        EXPECT_EQ(vibration.energies.viscous_loss_J > 0.1 * vibration.largest_J, viscosity > 0);
        EXPECT_EQ(vibration.energies.mass_damping_loss_J > 0.1 * vibration.largest_J, damping > 0);
      }
    }
}

// Hands that push the top down, as a contact does: displacements after each substep, at a frequency that the
// tissue's high vibrations follow.
TEST(Energy, WorkOfContactsClosesTheBalance) {
  for (const MaterialModel model : kModels)
    for (const auto& [viscosity, damping] : {std::pair{0.0, 0.0}, std::pair{3.0, 20.0}}) {
      const BlockMesh block = makeBlock({.cells = {4, 4, 4}, .irregularity = 0.4});
      const auto held = block.where([](const Vec3& p) { return p.z() == 0; });
      ElasticTissue tissue(block.mesh, {model, 1e4, 0.4, 1000, viscosity, damping}, held,
                           block.surface_vertices, {0, 0, -9.81});
      std::vector<Vec3> motion_m(static_cast<std::size_t>(block.surface_vertices));
      double worst_J = 0, lid_m = 0.04;
      for (int step = 0; step < 100; ++step) {
        const int substeps = 2 * tissue.substepsFor(1e-3);
        const double substep_s = 1e-3 / substeps;
        for (int i = 0; i < substeps; ++i) {
          tissue.advance(substep_s);
          lid_m -= 0.1 * substep_s;
          for (std::size_t v = 0; v < motion_m.size(); ++v) {
            const double above_m = std::max(0.0, tissue.positions_m()[v].z() - lid_m);
            motion_m[v] = {0, 0, -above_m};
            tissue.positions_m()[v] += motion_m[v];
          }
          tissue.addMotion(motion_m, substep_s);
        }
        worst_J = std::max(worst_J, std::abs(balance_J(tissue.energies())));
      }
      const ElasticEnergies energies = tissue.energies();
      EXPECT_GT(energies.stored_J, 0.3 * energies.contact_work_J);
      EXPECT_LT(worst_J, 0.001 * energies.contact_work_J);
    }
}

}  // namespace

}  // namespace fissure
