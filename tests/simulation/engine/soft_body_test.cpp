#include "engine/soft_body.h"

#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <gtest/gtest.h>

#include "engine/convert.h"
#include "mesh/primitives.h"

namespace fissure::soft_body_test {

namespace {

const PipelineSettings default_pipeline{.name = "default", .pipeline = PipelineKind::default_sdf};
const PipelineSettings cluster_pipeline{.name = "cluster", .pipeline = PipelineKind::cluster};

std::unique_ptr<btSoftBody> bulletsOwn(btSoftBodyWorldInfo& info, const TriangleMesh& mesh,
                                       const BodySettings& settings) {
  std::vector<btScalar> vertices;
  for (const Vec3& v : mesh.vertices_m)
    vertices.insert(vertices.end(), {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())});
  std::vector<int> faces;
  for (const Face& f : mesh.faces) faces.insert(faces.end(), f.begin(), f.end());
  std::unique_ptr<btSoftBody> body(btSoftBodyHelpers::CreateFromTriMesh(
      info, vertices.data(), faces.data(), static_cast<int>(mesh.faces.size()), settings.randomize_links));
  body->generateBendingConstraints(settings.bending_distance);
  body->setTotalMass(btScalar(settings.mass_kg), settings.mass_from_faces);
  return body;
}

class SoftBodyLinks : public testing::TestWithParam<std::tuple<int, int, bool>> {};

// Our tables are sparse; the links must be Bullet's, in Bullet's order.
TEST_P(SoftBodyLinks, AreBulletsLinkForLink) {
  const auto [subdivisions, distance, randomize] = GetParam();
  const TriangleMesh mesh = makeSphere(0.03, subdivisions);
  BodySettings settings;
  settings.bending_distance = distance;
  settings.randomize_links = randomize;
  btSoftBodyWorldInfo info;
  const auto ours = makeSoftBody(info, mesh, settings, default_pipeline);
  const auto theirs = bulletsOwn(info, mesh, settings);
  ASSERT_EQ(ours->m_links.size(), theirs->m_links.size());
  for (int i = 0; i < ours->m_links.size(); ++i) {
    for (int end = 0; end < 2; ++end) {
      ASSERT_EQ(ours->m_links[i].m_n[end] - &ours->m_nodes[0],
                theirs->m_links[i].m_n[end] - &theirs->m_nodes[0])
          << i;
    }
    ASSERT_EQ(ours->m_links[i].m_rl, theirs->m_links[i].m_rl);
    ASSERT_EQ(ours->m_links[i].m_bbending, theirs->m_links[i].m_bbending);
  }
  ASSERT_EQ(ours->m_faces.size(), theirs->m_faces.size());
  for (int i = 0; i < ours->m_faces.size(); ++i) {
    for (int j = 0; j < 3; ++j) {
      ASSERT_EQ(ours->m_faces[i].m_n[j] - &ours->m_nodes[0], theirs->m_faces[i].m_n[j] - &theirs->m_nodes[0]);
    }
  }
  for (int i = 0; i < ours->m_nodes.size(); ++i) ASSERT_EQ(ours->m_nodes[i].m_im, theirs->m_nodes[i].m_im);
}

INSTANTIATE_TEST_SUITE_P(SmallSpheres, SoftBodyLinks,
                         testing::Combine(testing::Values(0, 1, 2, 3), testing::Values(0, 2, 3),
                                          testing::Bool()));

TEST(SoftBody, AppliesEverySetting) {
  BodySettings settings;
  settings.mass_kg = 0.25;
  settings.margin_m = 0.003;
  settings.material = {.linear_stiffness = 0.11, .angular_stiffness = 0.12, .volume_stiffness = 0.13};
  settings.solver = {.velocity_correction = 0.21,
                     .damping = 0.22,
                     .drag = 0.23,
                     .lift = 0.24,
                     .pressure = 0.25,
                     .volume_conservation = 0.26,
                     .dynamic_friction = 0.27,
                     .pose_matching = 0.28,
                     .rigid_hardness = 0.29,
                     .soft_hardness = 0.31,
                     .anchor_hardness = 0.32,
                     .max_volume = 1.33,
                     .time_scale = 1.34,
                     .velocity_iterations = 3,
                     .position_iterations = 4,
                     .drift_iterations = 5,
                     .aero_model = AeroModel::F_TwoSidedLiftDrag};
  btSoftBodyWorldInfo info;
  PipelineSettings hard = default_pipeline;
  hard.kinematic_hardness = 0.77;
  const auto body = makeSoftBody(info, makeSphere(0.03, 2), settings, hard);
  EXPECT_EQ(body->m_materials[0]->m_kLST, btScalar(0.11));
  EXPECT_EQ(body->m_materials[0]->m_kAST, btScalar(0.12));
  EXPECT_EQ(body->m_materials[0]->m_kVST, btScalar(0.13));
  const btSoftBody::Config& config = body->m_cfg;
  EXPECT_EQ(config.kVCF, btScalar(0.21));
  EXPECT_EQ(config.kDP, btScalar(0.22));
  EXPECT_EQ(config.kDG, btScalar(0.23));
  EXPECT_EQ(config.kLF, btScalar(0.24));
  EXPECT_EQ(config.kPR, btScalar(0.25));
  EXPECT_EQ(config.kVC, btScalar(0.26));
  EXPECT_EQ(config.kDF, btScalar(0.27));
  EXPECT_EQ(config.kMT, btScalar(0.28));
  EXPECT_EQ(config.kCHR, btScalar(0.29));
  EXPECT_EQ(config.kKHR, btScalar(0.77));
  EXPECT_EQ(config.kSHR, btScalar(0.31));
  EXPECT_EQ(config.kAHR, btScalar(0.32));
  EXPECT_EQ(config.maxvolume, btScalar(1.33));
  EXPECT_EQ(config.timescale, btScalar(1.34));
  EXPECT_EQ(config.viterations, 3);
  EXPECT_EQ(config.piterations, 4);
  EXPECT_EQ(config.diterations, 5);
  EXPECT_EQ(config.aeromodel, btSoftBody::eAeroModel::F_TwoSidedLiftDrag);
  EXPECT_NEAR(body->getTotalMass(), 0.25, 1e-12);
  EXPECT_EQ(body->getCollisionShape()->getMargin(), btScalar(0.003));
  EXPECT_TRUE(body->m_pose.m_bvolume);
  EXPECT_TRUE(body->m_pose.m_bframe);
}

TEST(SoftBody, MeetsRigidAndSoftBodiesAsAsked) {
  using Flags = btSoftBody::fCollision;
  btSoftBodyWorldInfo info;
  const auto flags = [&](SoftContact soft_contact, const PipelineSettings& pipeline) {
    BodySettings settings;
    settings.soft_contact = soft_contact;
    return makeSoftBody(info, makeSphere(0.03, 1), settings, pipeline)->m_cfg.collisions;
  };
  EXPECT_EQ(flags(SoftContact::none, default_pipeline), Flags::SDF_RS);
  EXPECT_EQ(flags(SoftContact::vertices, default_pipeline), Flags::SDF_RS | Flags::VF_SS);
  EXPECT_EQ(flags(SoftContact::clusters, default_pipeline), Flags::SDF_RS | Flags::CL_SS);
  EXPECT_EQ(flags(SoftContact::none, cluster_pipeline), Flags::CL_RS);
  EXPECT_EQ(flags(SoftContact::vertices, cluster_pipeline), Flags::CL_RS | Flags::VF_SS);
}

TEST(SoftBody, AppliesEverySettingOfItsClusters) {
  BodySettings settings;
  settings.clusters = {.count = 5,
                       .iterations = 6,
                       .rigid_hardness = 0.21,
                       .kinematic_hardness = 0.22,
                       .soft_hardness = 0.23,
                       .rigid_split = 0.24,
                       .kinematic_split = 0.25,
                       .soft_split = 0.26,
                       .node_damping = 0.27,
                       .linear_damping = 0.28,
                       .angular_damping = 0.29,
                       .matching = 0.31};
  btSoftBodyWorldInfo info;
  const auto body = makeSoftBody(info, makeSphere(0.03, 2), settings, cluster_pipeline);
  const btSoftBody::Config& config = body->m_cfg;
  EXPECT_EQ(config.citerations, 6);
  EXPECT_EQ(config.kSRHR_CL, btScalar(0.21));
  EXPECT_EQ(config.kSKHR_CL, btScalar(0.22));
  EXPECT_EQ(config.kSSHR_CL, btScalar(0.23));
  EXPECT_EQ(config.kSR_SPLT_CL, btScalar(0.24));
  EXPECT_EQ(config.kSK_SPLT_CL, btScalar(0.25));
  EXPECT_EQ(config.kSS_SPLT_CL, btScalar(0.26));
  ASSERT_EQ(body->m_clusters.size(), 6);  // and Bullet's own, of the whole body
  EXPECT_EQ(body->m_clusters[1]->m_ndamping, btScalar(0.27));
  EXPECT_EQ(body->m_clusters[1]->m_ldamping, btScalar(0.28));
  EXPECT_EQ(body->m_clusters[1]->m_adamping, btScalar(0.29));
  EXPECT_EQ(body->m_clusters[1]->m_matching, btScalar(0.31));
  PipelineSettings tuned = cluster_pipeline;
  tuned.settings = SettingsPreset::tuned;
  EXPECT_EQ(makeSoftBody(info, makeSphere(0.03, 2), settings, tuned)->m_cfg.citerations, 20);
  EXPECT_EQ(makeSoftBody(info, makeSphere(0.03, 2), settings, default_pipeline)->m_clusters.size(), 0)
      << "clusters that nothing needs";
}

// Bullet's own tables would need 16 386 x 16 386 words here.
TEST(SoftBody, BuildsALargeBody) {
  btSoftBodyWorldInfo info;
  BodySettings settings;
  const auto body = makeSoftBody(info, makeSphere(0.03, 6), settings, default_pipeline);
  EXPECT_EQ(body->m_faces.size(), 32768);
}

}  // namespace
}  // namespace fissure::soft_body_test
