// Bars: how far one stretches that hangs, and how fast waves run in it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "block_mesh.h"
#include "tissue_probe.h"

namespace fissure {

namespace {

// Without a Poisson's ratio a bar of length L that is held above stretches by rho g L^2 / (2 E): 0.1 % here,
// at moduli from 10 Pa to 10 MPa.
TEST(Bar, HangingStretchesAsTheClosedFormSays) {
  constexpr double kLength_m = 0.1, kDensity = 1000, kStretch = 1e-3;
  const BlockMesh block =
      makeBlock({.cells = {2, 2, 10}, .size_m = {0.02, 0.02, kLength_m}, .irregularity = 0.3});
  const auto held = block.where([](const Vec3& p) { return p.z() == kLength_m; });
  for (const MaterialModel model : kModels)
    for (const double modulus_Pa : {10.0, 1e4, 1e7}) {
      const double speed_m_s = std::sqrt(modulus_Pa / kDensity);
      const double slowest_1_s = std::numbers::pi / 2 * speed_m_s / kLength_m;
      const double gravity_m_s2 = 2 * kStretch * modulus_Pa / (kDensity * kLength_m);
      ElasticTissue tissue(block.mesh, {model, modulus_Pa, 0, kDensity, 0, 2 * slowest_1_s}, held,
                           block.surface_vertices, {0, 0, -gravity_m_s2});
      const double substep_s = 0.9 * tissue.criticalStep_s();
      for (double time_s = 0; time_s < 12 / slowest_1_s; time_s += substep_s) tissue.advance(substep_s);
      for (const int v : block.where([](const Vec3& p) { return p.z() == 0; }))
        EXPECT_NEAR(-tissue.positions_m()[v].z(), kStretch * kLength_m, 0.01 * kStretch * kLength_m)
            << modulus_Pa;
      // It loses half of what it sank by.
      const ElasticEnergies energies = tissue.energies();
      EXPECT_NEAR(energies.stored_J / -energies.gravity_J, 0.5, 0.005);
      EXPECT_NEAR(balance_J(energies), 0, 1e-3 * energies.stored_J);
    }
}

/// Speed of waves along x, from the first vibration of a free bar: the time between two turns of its end.
double waveSpeed_m_s(const ElasticMaterial& material, bool held_sideways) {
  constexpr double kLength_m = 0.4;
  constexpr int kCells = 80;
  const BlockMesh block = makeBlock({.cells = {kCells, 1, 1}, .size_m = {kLength_m, 0.005, 0.005}});
  ElasticTissue tissue(block.mesh, material, {}, block.surface_vertices, Vec3::Zero());
  const auto sideways = [&] {
    if (!held_sideways) return;
    for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v) {
      tissue.velocities_m_s()[v].tail<2>().setZero();
      tissue.positions_m()[v].tail<2>() = block.mesh.vertices_m[v].tail<2>();
    }
  };
  for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
    tissue.velocities_m_s()[v].x() =
        1e-4 * std::cos(std::numbers::pi * block.mesh.vertices_m[v].x() / kLength_m);
  const int end = block.where([](const Vec3& p) { return p == Vec3::Zero(); }).at(0);
  const double substep_s = 0.9 * tissue.criticalStep_s();
  double before_m_s = tissue.velocities_m_s()[end].x(), first_turn_s = 0;
  for (int step = 1; step < 10000; ++step) {
    tissue.advance(substep_s);
    sideways();
    const double now_m_s = tissue.velocities_m_s()[end].x();
    if ((now_m_s < 0) != (before_m_s < 0)) {
      const double turn_s = substep_s * (step - now_m_s / (now_m_s - before_m_s));
      if (first_turn_s > 0) return kLength_m / (turn_s - first_turn_s);  // half a period: there once
      first_turn_s = turn_s;
    }
    before_m_s = now_m_s;
  }
  return 0;
}

TEST(Bar, WavesRunAtTheirSpeed) {
  for (const MaterialModel model : kModels) {
    const double bar_m_s = std::sqrt(1e4 / 1000);
    EXPECT_NEAR(waveSpeed_m_s({model, 1e4, 0, 1000}, false), bar_m_s, 0.01 * bar_m_s);
    const LameConstants lame = lameConstants(1e4, 0.4);
    const double pressure_wave_m_s = std::sqrt((lame.lambda_Pa + 2 * lame.mu_Pa) / 1000);
    EXPECT_NEAR(waveSpeed_m_s({model, 1e4, 0.4, 1000}, true), pressure_wave_m_s, 0.01 * pressure_wave_m_s);
  }
}

// Time goes with the root of the modulus, and nothing else changes.
TEST(Bar, MotionIsTheSameAtAllModuli) {
  const BlockMesh block = makeBlock({.cells = {2, 2, 4}, .irregularity = 0.4});
  const auto held = block.where([](const Vec3& p) { return p.z() == 0; });
  for (const MaterialModel model : kModels) {
    std::vector<Vec3> reference_m;
    for (const double modulus_Pa : {1e4, 10.0, 1e7}) {
      const double speed_up = std::sqrt(modulus_Pa / 1e4);
      ElasticTissue tissue(block.mesh, {model, modulus_Pa, 0.4, 1000, 0.5 * speed_up}, held,
                           block.surface_vertices, Vec3::Zero());
      Random random;
      for (const int v : block.where([](const Vec3& p) { return p.z() > 0; }))
        tissue.velocities_m_s()[v] = 0.3 * speed_up * random.vector();
      for (int step = 0; step < 100; ++step) tissue.advance(2e-4 / speed_up);
      if (reference_m.empty()) reference_m.assign(tissue.positions_m().begin(), tissue.positions_m().end());
      for (std::size_t v = 0; v < reference_m.size(); ++v)
        EXPECT_LT((tissue.positions_m()[v] - reference_m[v]).norm(), 1e-10) << modulus_Pa;
    }
  }
}

}  // namespace

}  // namespace fissure
