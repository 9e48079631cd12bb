// A block without loads: what must not happen to it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "block_mesh.h"
#include "elastic/elastic_tissue.h"

namespace fissure {

namespace {

constexpr MaterialModel kModels[] = {MaterialModel::neo_hookean, MaterialModel::linear_corotated};

// Turned by 2 rad and moved: no force moves a vertex by more than rounding, at any Poisson's ratio.
TEST(RigidMotion, RotationGivesNoForce) {
  const BlockMesh block = makeBlock({.cells = {3, 4, 2}, .irregularity = 0.4});
  const Mat3 turn = Eigen::AngleAxisd(2, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const MaterialModel model : kModels)
    for (const double ratio : {0.0, 0.3, 0.49}) {
      ElasticTissue tissue(block.mesh, {model, 1e4, ratio, 1000}, {}, block.surface_vertices, Vec3::Zero());
      for (Vec3& position_m : tissue.positions_m()) position_m = turn * position_m + Vec3(1, 2, 3);
      const double substep_s = tissue.criticalStep_s();
      tissue.advance(substep_s);
      // A strain of 1e-3 accelerates by 1e-3 E / (rho cell), some 1 m/s^2.
      for (const Vec3& velocity_m_s : tissue.velocities_m_s())
        EXPECT_LT(velocity_m_s.norm() / substep_s, 1e-7) << ratio;
    }
}

}  // namespace

}  // namespace fissure
