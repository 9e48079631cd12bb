// The largest stable substep: just below it nothing grows, above it everything does.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "tissue_probe.h"
#include "two_materials.h"

namespace fissure {

namespace {

/// How much velocities of 1e-9 m/s have grown after `substeps` substeps of this size, from where the tissue
/// stands.
double growth(ElasticTissue& tissue, double substep_s, int substeps) {
  Random random;
  const std::vector<Vec3> held_m(tissue.positions_m().begin(), tissue.positions_m().end());
  for (std::size_t v = 0; v < held_m.size(); ++v)
    tissue.velocities_m_s()[v] =
        tissue.inverseMasses_1_kg()[v] > 0 ? Vec3(1e-9 * random.vector()) : Vec3::Zero();
  for (int i = 0; i < substeps; ++i) tissue.advance(substep_s);
  double sum_m_s = 0;  // not a number where one of them is not
  for (std::size_t v = 0; v < held_m.size(); ++v) {
    sum_m_s += tissue.velocities_m_s()[v].norm();
    tissue.positions_m()[v] = held_m[v];
  }
  return sum_m_s / (1e-9 * static_cast<double>(held_m.size()));
}

struct Case {
  const char* name;
  BlockShape shape;
  bool held;
};

const Case kCases[] = {
    {"regular, five", {.cells = {3, 3, 3}}, false},
    {"regular, six, held", {.cells = {3, 2, 4}, .split = CellSplit::six}, true},
    {"irregular", {.cells = {3, 3, 3}, .irregularity = 0.4}, false},
    {"very irregular, held", {.cells = {4, 3, 3}, .split = CellSplit::six, .irregularity = 0.6}, true},
    {"flat cells", {.cells = {3, 3, 3}, .size_m = {0.04, 0.04, 0.01}, .irregularity = 0.3}, false},
    {"one cell", {.cells = {1, 1, 1}}, false},
};

TEST(CriticalStep, IsTheLimitOfStability) {
  for (const Case& one : kCases) {
    const BlockMesh block = makeBlock(one.shape);
    const auto held = block.where([&](const Vec3& p) { return one.held && p.z() == 0; });
    for (const MaterialModel model : kModels)
      for (const double ratio : {0.0, 0.3, 0.45, 0.49, 0.4999})
        for (const double viscosity : {0.0, 0.5, 20.0}) {
          const ElasticMaterial material = {model, 1e4, ratio, 1000, viscosity, viscosity};
          ElasticTissue tissue(block.mesh, material, held, 0, Vec3::Zero());
          const double limit_s = tissue.criticalStep_s();
          EXPECT_LT(growth(tissue, 0.999 * limit_s, 200), 100)
              << one.name << " " << ratio << " " << viscosity;
          const double above = viscosity > 1 ? 1.1 : 1.01;  // slow to grow where damping sets the limit
          EXPECT_FALSE(growth(tissue, above * limit_s, 200) < 1e4)
              << one.name << " " << ratio << " " << viscosity;
        }
  }
}

/// Square of the highest frequency of a tissue where it stands, from differences of forces: power iteration,
/// twice, since the largest eigenvalue may be one of a shape that is not stable.
double highestFrequencySquared(ElasticTissue& tissue) {
  const std::vector<Vec3> at_m(tissue.positions_m().begin(), tissue.positions_m().end());
  constexpr double kMove_m = 1e-7;
  const auto power = [&](double shift) {
    std::vector<Vec3> direction(at_m.size());
    Random random;
    for (Vec3& vector : direction) vector = random.vector();
    double found = 0;
    for (int round = 0; round < 200; ++round) {
      double norm = 0;
      for (const Vec3& vector : direction) norm += vector.squaredNorm();
      const auto forces_N = [&](double by_m) {
        for (std::size_t v = 0; v < at_m.size(); ++v)
          tissue.positions_m()[v] = at_m[v] + by_m / std::sqrt(norm) * direction[v];
        return internalForces_N(tissue);
      };
      const std::vector<Vec3> ahead_N = forces_N(kMove_m), behind_N = forces_N(-kMove_m);
      double along = 0;
      for (std::size_t v = 0; v < at_m.size(); ++v) {
        const Vec3 unit = direction[v] / std::sqrt(norm);
        direction[v] = (behind_N[v] - ahead_N[v]) / (2 * kMove_m * tissue.masses_kg()[v]) + shift * unit;
        along += direction[v].dot(unit);
      }
      found = along - shift;
    }
    std::copy(at_m.begin(), at_m.end(), tissue.positions_m().begin());
    return found;
  };
  const double largest = power(0);
  return largest > 0 ? largest : power(-largest);
}

struct Stretch {
  const char* name;
  Mat3 gradient;
};

std::vector<Stretch> stretches() {
  const auto diagonal = [](double x, double y, double z) -> Mat3 { return Vec3(x, y, z).asDiagonal(); };
  Mat3 shear = Mat3::Identity();
  shear(0, 2) = 1;
  std::vector<Stretch> found = {{"none", Mat3::Identity()},
                                {"laterally 1.5", diagonal(1.5, 1.5, 1)},
                                {"laterally 1.5, thinner", diagonal(1.5, 1.5, 1 / 2.25)},
                                {"along 2", diagonal(2, 1 / std::sqrt(2), 1 / std::sqrt(2))},
                                {"all 1.3", diagonal(1.3, 1.3, 1.3)},
                                {"all 0.7", diagonal(0.7, 0.7, 0.7)},
                                {"pressed to a half", diagonal(1.2, 1.2, 0.5)},
                                {"confined to a half", diagonal(1, 1, 0.5)},
                                {"shear", shear}};
  Random random;
  for (int i = 0; i < 6; ++i) {
    Mat3 some = Mat3::Identity();
    for (int k = 0; k < 9; ++k) some(k / 3, k % 3) += 0.4 * random();
    found.push_back({"random", some});
  }
  return found;
}

// Stretched, the estimate is at most 1 % above what is stable (corotated elements without a Poisson's ratio,
// whose swollen shape resists rotations), which kStepSafety covers, and at least half of it.
TEST(CriticalStep, FollowsTheStretch) {
  for (const double irregularity : {0.0, 0.4}) {
    const BlockMesh block = makeBlock({.cells = {3, 3, 3}, .irregularity = irregularity});
    for (const MaterialModel model : kModels)
      for (const double ratio : {0.0, 0.3, 0.45, 0.49, 0.4999})
        for (const Stretch& stretch : stretches()) {
          ElasticTissue tissue(block.mesh, {model, 1e4, ratio, 1000}, {}, 0, Vec3::Zero());
          for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
            tissue.positions_m()[v] = stretch.gradient * block.mesh.vertices_m[v];
          tissue.substepsFor(1e-3);
          const double limit_s = 2 / std::sqrt(highestFrequencySquared(tissue));
          EXPECT_LT(tissue.criticalStep_s(), 1.01 * limit_s) << stretch.name << " " << ratio;
          const bool softens =
              model == MaterialModel::saint_venant_kirchhoff && stretch.gradient.determinant() < 0.5;
          EXPECT_GT(tissue.criticalStep_s(), (softens ? 0.24 : 0.5) * limit_s)
              << stretch.name << " " << ratio;
        }
  }
}

// Two layers, the lower one stiffer or softer, that share their stretch sideways and have their own along z.
TEST(CriticalStep, FollowsTheStretchOfEachMaterial) {
  const BlockMesh block = makeBlock({.cells = {3, 3, 4}, .size_m = {0.04, 0.04, 0.04}});
  const auto isBelow = [](const Vec3& p) { return p.z() < 0.02; };
  for (const MaterialModel model : kModels)
    for (const auto& [upper_ratio, lower_ratio] : {std::pair{0.3, 0.3}, std::pair{0.49, 0.3}})
      for (const double contrast : {0.01, 0.5, 3.0, 100.0})
        for (const double sideways : {1.0, 1.3})
          for (const auto& [upper, lower] : {std::pair{1.0, 1.5}, std::pair{1.5, 1.0}, std::pair{0.8, 1.5},
                                             std::pair{0.6, 1.0}, std::pair{1.0, 1.0}}) {
            ElasticTissue tissue(block.mesh,
                                 twoMaterials(block.mesh, {model, 1e4, upper_ratio, 1000},
                                              {model, contrast * 1e4, lower_ratio, 1000}, isBelow),
                                 {}, 0, Vec3::Zero());
            for (Vec3& position_m : tissue.positions_m()) {
              const double above_m = std::max(0.0, position_m.z() - 0.02);
              position_m = {sideways * position_m.x(), sideways * position_m.y(),
                            lower * (position_m.z() - above_m) + upper * above_m};
            }
            tissue.substepsFor(1e-3);
            const double limit_s = 2 / std::sqrt(highestFrequencySquared(tissue));
            EXPECT_LT(tissue.criticalStep_s(), 1.01 * limit_s)
                << upper_ratio << " " << contrast << " " << sideways << " " << upper << " " << lower;
            EXPECT_GT(tissue.criticalStep_s(), 0.5 * limit_s)
                << upper_ratio << " " << contrast << " " << sideways << " " << upper << " " << lower;
          }
}

/// Whether no wave in tissue of this stretch grows by itself, at any step, as compressed tissue of some laws
/// does (material.h). Says no more often than it must.
bool isElliptic(const ElasticMaterial& material, const Mat3& f) {
  if (material.model == MaterialModel::neo_hookean) return true;
  if (material.model == MaterialModel::linear_corotated) return f.determinant() >= 0.67;
  const LameConstants lame = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio);
  const Vec3 squares = f.jacobiSvd().singularValues().array().square();
  const double least_stress_Pa =
      lame.mu_Pa * (squares.minCoeff() - 1) + lame.lambda_Pa / 2 * (squares.sum() - 3);
  return lame.mu_Pa * squares.minCoeff() + least_stress_Pa > 0;
}

// With viscosity too: the inside of a block whose surface is held stretched.
TEST(CriticalStep, HoldsForViscousTissueThatIsStretched) {
  const BlockMesh block = makeBlock({.cells = {4, 4, 4}, .irregularity = 0.4});
  std::vector<int> surface;
  for (int v = 0; v < block.surface_vertices; ++v) surface.push_back(v);
  for (const MaterialModel model : kModels)
    for (const double viscosity : {0.0, 0.5, 3.0, 20.0})
      for (const Stretch& stretch : stretches()) {
        const ElasticMaterial material = {model, 1e4, 0.4, 1000, viscosity};
        if (!isElliptic(material, stretch.gradient)) continue;
        ElasticTissue tissue(block.mesh, material, surface, 0, Vec3::Zero());
        for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
          tissue.positions_m()[v] = stretch.gradient * block.mesh.vertices_m[v];
        tissue.substepsFor(1e-3);
        EXPECT_LT(growth(tissue, ElasticTissue::kStepSafety * tissue.criticalStep_s(), 200), 100)
            << stretch.name << " " << viscosity;
      }
}

struct Pulled {
  int first_substeps = 0, last_substeps = 0;
  bool calm = false;  ///< finite, and hardly moving at the end
};

/// A sheet whose rim is pulled outwards to 1.7 of its size in 0.1 s and held there, in steps of 1 ms.
Pulled pullSheet(bool watched) {
  const BlockMesh block = makeBlock({.cells = {5, 5, 2}, .size_m = {0.04, 0.04, 0.008}, .irregularity = 0.3});
  ElasticTissue tissue(block.mesh, {MaterialModel::neo_hookean, 1e4, 0.45, 1000, 0.5}, {}, 0, Vec3::Zero());
  const auto rim =
      block.where([](const Vec3& p) { return p.x() == 0 || p.x() == 0.04 || p.y() == 0 || p.y() == 0.04; });
  Pulled pulled;
  pulled.first_substeps = tissue.substepsFor(1e-3);
  double time_s = 0;
  for (int step = 0; step < 300 && tissue.finite(); ++step) {
    pulled.last_substeps = watched ? tissue.substepsFor(1e-3) : pulled.first_substeps;
    for (int i = 0; i < pulled.last_substeps; ++i) {
      tissue.advance(1e-3 / pulled.last_substeps);
      time_s += 1e-3 / pulled.last_substeps;
      const double stretch = 1 + 0.7 * std::min(1.0, time_s / 0.1);
      for (const int v : rim) {
        tissue.positions_m()[v].head<2>() = stretch * block.mesh.vertices_m[v].head<2>();
        tissue.velocities_m_s()[v].head<2>().setZero();
      }
    }
  }
  pulled.calm = tissue.finite() && tissue.energies().kinetic_J < 1e-5 * tissue.energies().stored_J;
  return pulled;
}

// A jump of the tools stretches tissue more than their own speed does; what is slow again asks for no more
// substeps than its stretch now, and has foreseen nothing.
TEST(CriticalStep, SubstepsFallWhenToolsSlowDown) {
  const BlockMesh block = makeBlock({});
  ElasticTissue tissue(block.mesh, {MaterialModel::neo_hookean, 1e4, 0.45, 1000, 0.5}, {}, 0, Vec3::Zero());
  const auto stretch = [&](double factor) {
    for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
      tissue.positions_m()[v] = block.mesh.vertices_m[v].cwiseProduct(Vec3(factor, 1, 1));
    return tissue.substepsFor(1e-2);
  };
  const int at_rest = stretch(1);
  ASSERT_GT(at_rest, 3);
  tissue.changeTempo(10);
  const int in_the_jump = stretch(2);
  EXPECT_GT(in_the_jump, 1.5 * at_rest);
  tissue.changeTempo(1);
  EXPECT_EQ(stretch(1), in_the_jump) << "as long as the tempo stays";
  stretch(1.5);
  tissue.changeTempo(0.1);
  ElasticTissue fresh(block.mesh, {MaterialModel::neo_hookean, 1e4, 0.45, 1000, 0.5}, {}, 0, Vec3::Zero());
  std::copy(tissue.positions_m().begin(), tissue.positions_m().end(), fresh.positions_m().begin());
  fresh.changeTempo(0.1);  // foresees nothing
  const int slow_again = tissue.substepsFor(1e-2);
  EXPECT_EQ(slow_again, std::max(at_rest, fresh.substepsFor(1e-2)));
  EXPECT_LT(slow_again, in_the_jump);
}

TEST(CriticalStep, SubstepsRiseBeforeTheLimitIsMet) {
  const Pulled watched = pullSheet(true), not_watched = pullSheet(false);
  EXPECT_TRUE(watched.calm);
  EXPECT_FALSE(not_watched.calm);
  EXPECT_GT(watched.last_substeps, 1.5 * watched.first_substeps);
}

}  // namespace

}  // namespace fissure
