// Nearly incompressible tissue: averaged pressure against elements that each keep their volume.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "block_mesh.h"
#include "elastic/element_forces.h"

namespace fissure {

namespace {

constexpr double kYoungsModulus_Pa = 1e4, kDensity = 1000, kGravity_m_s2 = 0.01;

/// A linear problem on a mesh: its stiffness by columns, from forces of unit displacements.
class Statics {
 public:
  Statics(const BlockMesh& block, double ratio, bool averaged) : block_(block) {
    const ElasticMaterial material = {MaterialModel::linear_corotated, kYoungsModulus_Pa, ratio, kDensity};
    ElementForces forces(block.mesh, {{material}, {}}, InstructionSet::baseline);
    const Eigen::Index size = 3 * static_cast<Eigen::Index>(block.mesh.vertices_m.size());
    stiffness_ = Eigen::MatrixXd(size, size);
    const ElementArrays arrays = forces.arrays();
    std::vector<double> displacements_m(static_cast<std::size_t>(size) + 1),
        slots(4 * (4 * block.mesh.tetrahedra.size() + 1));
    const LameConstants lame = lameConstants(kYoungsModulus_Pa, ratio);
    for (Eigen::Index column = 0; column < size; ++column) {
      displacements_m[static_cast<std::size_t>(column)] = 1;
      const double* found = slots.data();
      if (averaged) {
        forces.computeSmall(displacements_m.data(), forces.smallStrainLaws());
        found = forces.forceSlots();
      } else {
        forces.kernels().forces(arrays, {ElementModel::small_strain, lame.mu_Pa, lame.lambda_Pa},
                                {.positions_m = displacements_m.data(), .forces_N = slots.data()});
      }
      displacements_m[static_cast<std::size_t>(column)] = 0;
      for (int v = 0; v < arrays.vertices; ++v) {
        Vec3 force_N = Vec3::Zero();
        for (int slot = arrays.first_slots[v]; slot < arrays.first_slots[v + 1]; ++slot)
          force_N += Eigen::Map<const Vec3>(found + 4 * slot);
        stiffness_.block<3, 1>(3 * v, column) = -force_N;
      }
    }
    weights_N = Eigen::VectorXd::Zero(size);
    for (int v = 0; v < arrays.vertices; ++v)
      weights_N[3 * v + 2] =
          -kDensity * kGravity_m_s2 * forces.vertexVolumes_m3()[static_cast<std::size_t>(v)];
  }

  /// Displacements where those of `held` degrees of freedom are given.
  Eigen::VectorXd solve(const std::vector<std::pair<int, double>>& held) const {
    const double stiff = 1e8 * stiffness_.diagonal().maxCoeff();
    Eigen::MatrixXd matrix = stiffness_;
    Eigen::VectorXd load_N = weights_N;
    for (const auto& [degree, displacement_m] : held) {
      matrix(degree, degree) += stiff;
      load_N[degree] += stiff * displacement_m;
    }
    return matrix.ldlt().solve(load_N);
  }

  const Eigen::MatrixXd& stiffness() const { return stiffness_; }

  Eigen::VectorXd weights_N;

 private:
  const BlockMesh& block_;
  Eigen::MatrixXd stiffness_;
};

/// Sag of the end of a beam that is clamped at x = 0, over that of Timoshenko's theory.
double sagOverTheory(double ratio, bool averaged, CellSplit split) {
  constexpr double kLength_m = 0.08, kHeight_m = 0.02;
  const BlockMesh block = makeBlock({.cells = {12, 3, 3},
                                     .size_m = {kLength_m, kHeight_m, kHeight_m},
                                     .split = split,
                                     .irregularity = 0.2});
  const Statics statics(block, ratio, averaged);
  std::vector<std::pair<int, double>> held;
  for (const int v : block.where([](const Vec3& p) { return p.x() == 0; }))
    for (int i = 0; i < 3; ++i) held.emplace_back(3 * v + i, 0);
  const Eigen::VectorXd moved = statics.solve(held);
  double sag_m = 0;
  const auto end = block.where([](const Vec3& p) { return p.x() == kLength_m; });
  for (const int v : end) sag_m -= moved[3 * v + 2] / static_cast<double>(end.size());
  const double load_N_m = kDensity * kGravity_m_s2 * kHeight_m * kHeight_m;
  const double inertia_m4 = std::pow(kHeight_m, 4) / 12, area_m2 = kHeight_m * kHeight_m;
  const double shear_Pa = kYoungsModulus_Pa / (2 * (1 + ratio));
  return sag_m / (load_N_m * std::pow(kLength_m, 4) / (8 * kYoungsModulus_Pa * inertia_m4) +
                  load_N_m * kLength_m * kLength_m / (2 * 5.0 / 6 * shear_Pa * area_m2));
}

// 12 x 3 x 3 cells. Bending alone is stiff in linear tetrahedra: at 0.3 they sag by 0.79 (five in a cell) and
// 0.68 (six) of theory. Towards 0.5 locking takes nearly all of the rest in cells of six, and averaging keeps
// most of it.
TEST(Locking, BendingIsCloserToTheory) {
  struct Expected {
    CellSplit split;
    double ratio, locked, averaged;
  };
  for (const Expected& one :
       {Expected{CellSplit::five, 0.3, 0.794, 0.794}, Expected{CellSplit::five, 0.46, 0.696, 0.738},
        Expected{CellSplit::five, 0.49, 0.622, 0.686}, Expected{CellSplit::six, 0.3, 0.680, 0.680},
        Expected{CellSplit::six, 0.46, 0.430, 0.628}, Expected{CellSplit::six, 0.49, 0.228, 0.589},
        Expected{CellSplit::six, 0.499, 0.094, 0.552}}) {
    EXPECT_NEAR(sagOverTheory(one.ratio, false, one.split), one.locked, 1e-3) << one.ratio;
    EXPECT_NEAR(sagOverTheory(one.ratio, true, one.split), one.averaged, 1e-3) << one.ratio;
  }
}

/// Force that presses a block by 1 % between plates that it is bonded to.
double compressionForce_N(double ratio, bool averaged, int cells) {
  constexpr double kSide_m = 0.04;
  const BlockMesh block = makeBlock({.cells = {cells, cells, cells},
                                     .size_m = {kSide_m, kSide_m, kSide_m},
                                     .split = CellSplit::six,
                                     .irregularity = 0.2});
  Statics statics(block, ratio, averaged);
  statics.weights_N.setZero();
  std::vector<std::pair<int, double>> held;
  const std::vector<int> top = block.where([](const Vec3& p) { return p.z() == kSide_m; });
  for (const int v : block.where([](const Vec3& p) { return p.z() == 0 || p.z() == kSide_m; }))
    for (int i = 0; i < 3; ++i)
      held.emplace_back(3 * v + i, i == 2 && block.mesh.vertices_m[v].z() > 0 ? -4e-4 : 0.0);
  const Eigen::VectorXd forces_N = statics.stiffness() * statics.solve(held);
  double force_N = 0;
  for (const int v : top) force_N -= forces_N[3 * v + 2];
  return force_N;
}

// Elements that keep their volume are too stiff on every mesh, and less so on finer ones: 27 averaged cells
// are closer to the limit than 216 locked ones.
TEST(Locking, CompressionIsCloserToTheLimit) {
  EXPECT_EQ(compressionForce_N(0.3, true, 3), compressionForce_N(0.3, false, 3));
  const double locked_3_N = compressionForce_N(0.49, false, 3),
               locked_6_N = compressionForce_N(0.49, false, 6);
  const double averaged_3_N = compressionForce_N(0.49, true, 3),
               averaged_6_N = compressionForce_N(0.49, true, 6);
  EXPECT_LT(locked_6_N, 0.7 * locked_3_N);
  EXPECT_LT(averaged_3_N, 0.95 * locked_6_N);
  EXPECT_LT(averaged_6_N, averaged_3_N);
  EXPECT_GT(averaged_6_N, 0.75 * averaged_3_N);
}

}  // namespace

}  // namespace fissure
