#include "contact/triangle_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/primitives.h"

namespace fissure {
namespace {

/// One body, a box of 12 triangles; one contact on face 0 with normal -y (the tool stands above).
class TriangleForcesTest : public testing::Test {
 protected:
  TriangleForcesTest() {
    scene.bodies.push_back({.name = "box", .rest = makeBox({0.02, 0.02, 0.02})});
    state.positions_m = scene.bodies[0].rest.vertices_m;
    state.velocities_m_s.assign(state.positions_m.size(), Vec3::Zero());
    patch.resize(scene.vertexCount(), scene.faceCount(), true);
    patch.clear();
  }
  TriangleForces forces() {
    std::vector<TriangleLaw> laws;
    laws.push_back({makeHuntCrossley(200, 50, 1.3), RateSource::velocities});
    laws.push_back({makeLinearElastic(100)});
    laws.push_back({makeHuntCrossley(200, 50, 1.3), RateSource::differences});
    return TriangleForces(scene, std::move(laws), 0.001);
  }
  void touchFace(int face, const Vec3& normal) {
    patch.face_normals[face] += normal;
    for (const int vertex : scene.bodies[0].rest.faces[face]) {
      patch.vertex_contact[vertex] = 1;
      patch.vertex_normals[vertex] += normal / 3;
    }
  }
  Scene scene;
  State state;
  ContactPatch patch;
};

TEST_F(TriangleForcesTest, WithoutContactThereIsNoForceHoweverDeformed) {
  for (Vec3& p : state.positions_m) p += Vec3(0, -0.005, 0);
  forces().evaluate(patch, state);
  ASSERT_EQ(state.forces.size(), 3u);
  EXPECT_EQ(state.forces[0].elastic_N, 0);
  EXPECT_EQ(state.forces[1].force_on_tool_N, Vec3::Zero());
}

TEST_F(TriangleForcesTest, SumsTheLawOverAllTrianglesWithACollidingVertex) {
  // All vertices 5 mm down at 0.2 m/s: x = 5 mm, x' = 0.2 m/s in every triangle.
  for (Vec3& p : state.positions_m) p += Vec3(0, -0.005, 0);
  for (Vec3& v : state.velocities_m_s) v = Vec3(0, -0.2, 0);
  touchFace(0, -Vec3::UnitY());
  const Face& touched = scene.bodies[0].rest.faces[0];
  int colliding = 0;
  for (const Face& face : scene.bodies[0].rest.faces) {
    bool any = false;
    for (const int v : face) any |= v == touched[0] || v == touched[1] || v == touched[2];
    colliding += any ? 1 : 0;
  }
  ASSERT_GT(colliding, 1);
  ASSERT_LE(colliding, 12);
  forces().evaluate(patch, state);
  const double power = std::pow(0.005, 1.3);
  EXPECT_NEAR(state.forces[0].elastic_N, colliding * 200 * power, 1e-12);
  EXPECT_NEAR(state.forces[0].viscous_N, colliding * 50 * power * 0.2, 1e-12);
  EXPECT_NEAR((state.forces[0].force_on_tool_N - Vec3(0, colliding * (200 + 10) * power, 0)).norm(), 0, 1e-12)
      << "tissue pushed down pushes the tool up";
  EXPECT_NEAR(state.forces[1].elastic_N, colliding * 100 * 0.005, 1e-12);
}

TEST_F(TriangleForcesTest, RateIsTheGrowthOfTheDistanceNotTheSpeed) {
  // Displaced along -y, moving along x only: the distance does not grow.
  for (Vec3& p : state.positions_m) p += Vec3(0, -0.005, 0);
  for (Vec3& v : state.velocities_m_s) v = Vec3(0.7, 0, 0);
  touchFace(0, -Vec3::UnitY());
  forces().evaluate(patch, state);
  EXPECT_NEAR(state.forces[0].viscous_N, 0, 1e-15);
}

TEST_F(TriangleForcesTest, RateByDifferencesIsTheWayOfTheCentroidInTheStep) {
  // At rest, then 5 mm down, then 0.1 mm further in 1 ms: x' = 0.1 m/s, whatever the engine says of
  // velocities.
  for (Vec3& v : state.velocities_m_s) v = Vec3(0, 30, 0);
  touchFace(0, -Vec3::UnitY());
  TriangleForces evaluated = forces();
  for (Vec3& p : state.positions_m) p += Vec3(0, -0.005, 0);
  evaluated.evaluate(patch, state);
  for (Vec3& p : state.positions_m) p += Vec3(0, -0.0001, 0);
  evaluated.evaluate(patch, state);
  EXPECT_NEAR(state.forces[2].viscous_N / state.forces[2].elastic_N, 50 * 0.1 / 200, 1e-9);
  EXPECT_GT(state.forces[0].adhesion_clamped, 0) << "the engine's 30 m/s upwards would pull";
  evaluated.evaluate(patch, state);
  EXPECT_EQ(state.forces[2].viscous_N, 0) << "held";
}

TEST_F(TriangleForcesTest, CountsClampedTriangles) {
  for (Vec3& p : state.positions_m) p += Vec3(0, -0.005, 0);
  for (Vec3& v : state.velocities_m_s) v = Vec3(0, 5, 0);  // back up, faster than k / lambda = 4 m/s
  touchFace(0, -Vec3::UnitY());
  forces().evaluate(patch, state);
  EXPECT_GT(state.forces[0].adhesion_clamped, 0);
  EXPECT_EQ(state.forces[0].force_on_tool_N, Vec3::Zero());
  EXPECT_EQ(state.forces[1].adhesion_clamped, 0);
}

TEST_F(TriangleForcesTest, AMirroredSceneGivesTheMirroredForce) {
  for (std::size_t i = 0; i < state.positions_m.size(); ++i) {
    state.positions_m[i] += Vec3(0.001 * static_cast<double>(i), -0.004, 0.0005);
    state.velocities_m_s[i] = Vec3(0.01, -0.1, 0.02 * static_cast<double>(i));
  }
  touchFace(0, Vec3(0.6, -0.8, 0));
  forces().evaluate(patch, state);
  const Vec3 force = state.forces[0].force_on_tool_N;
  const auto mirror = [](Vec3& v) { v.x() = -v.x(); };
  for (Vec3& v : scene.bodies[0].rest.vertices_m) mirror(v);
  for (Vec3& v : state.positions_m) mirror(v);
  for (Vec3& v : state.velocities_m_s) mirror(v);
  for (Vec3& v : patch.face_normals) mirror(v);
  for (Vec3& v : patch.vertex_normals) mirror(v);
  forces().evaluate(patch, state);
  EXPECT_NEAR((state.forces[0].force_on_tool_N - Vec3(-force.x(), force.y(), force.z())).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace fissure
