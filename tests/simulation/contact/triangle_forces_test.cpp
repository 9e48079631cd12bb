#include "contact/triangle_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/primitives.h"

namespace fissure::triangle_forces_test {

namespace {

/// One body, a box of 12 triangles; one contact on face 0 with normal -y (the tool stands above).
class TriangleForcesTest : public testing::Test {
 protected:
  TriangleForcesTest() {
    scene.bodies.push_back({.name = "box", .rest = makeBox({0.02, 0.02, 0.02})});
    scene.tools.resize(1);
    state.positions_m = scene.bodies[0].rest.vertices_m;
    state.velocities_m_s.assign(state.positions_m.size(), Vec3::Zero());
    patch.resize(scene.vertexCount(), scene.faceCount(), 1);
    patch.clear();
  }
  TriangleForces forces(bool keeps_inputs = false) {
    std::vector<TriangleLaw> laws;
    laws.push_back(
        {ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3}), RateSource::velocities});
    laws.push_back({ForceLaw(ForceModel::linear_elastic, {.k = 100})});
    laws.push_back(
        {ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3}), RateSource::differences});
    return TriangleForces(scene, std::move(laws), 0.001, keeps_inputs);
  }
  void touchFace(int face, const Vec3& normal) {
    patch.touchFace(0, face, normal, 1);
    for (const int vertex : scene.bodies[0].rest.faces[face])
      patch.touchVertex(0, vertex, 1.0 / 3, normal, 1);
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

/// All kinds of laws on the box, deformed in no particular way, with contacts on two faces.
std::vector<TriangleLaw> allKinds() {
  std::vector<TriangleLaw> laws;
  for (const DeformationKind kind : {DeformationKind::paper, DeformationKind::corotated})
    for (const RateSource rate : {RateSource::differences, RateSource::velocities})
      for (const bool per_area : {false, true})
        laws.push_back(
            {ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3}), rate, kind, per_area});
  return laws;
}

void expectNear(const Vec3& found, const Vec3& expected, double tolerance) {
  EXPECT_LE((found - expected).norm(), tolerance)
      << found.transpose() << " instead of " << expected.transpose();
}

// Mirrored in x = 0 (a reflection: the corotated fit must not take it for a rotation of its own), and turned
// by a proper rotation.
TEST_F(TriangleForcesTest, ForcesOfEveryKindMirrorAndTurnWithTheScene) {
  const Mat3 turn = Quat(0.5, 0.1, -0.7, 0.5).normalized().toRotationMatrix();
  const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
  const auto evaluate = [&](const Mat3& map) {
    Scene mapped = scene;
    for (Vec3& v : mapped.bodies[0].rest.vertices_m) v = map * v;
    TriangleForces forces(mapped, allKinds(), 0.001);
    patch.clear();
    touchFace(0, map * Vec3(0.6, -0.8, 0));
    touchFace(5, map * Vec3(0, 0.8, 0.6));
    for (int step = 1; step <= 2; ++step) {
      for (std::size_t i = 0; i < state.positions_m.size(); ++i) {
        const double v = static_cast<double>(i);
        state.positions_m[i] =
            map * (scene.bodies[0].rest.vertices_m[i] + 0.0001 * step * Vec3(v, -40, 5 + v * v));
        state.velocities_m_s[i] = map * Vec3(0.01, -0.1, 0.02 * v);
      }
      forces.evaluate(patch, state);
    }
    std::vector<Vec3> found;
    for (const ForceSample& sample : state.forces) found.push_back(sample.force_on_tool_N);
    return found;
  };
  const std::vector<Vec3> plain = evaluate(Mat3::Identity());
  for (const Mat3& map : {turn, mirror}) {
    const std::vector<Vec3> mapped = evaluate(map);
    for (std::size_t law = 0; law < plain.size(); ++law) {
      EXPECT_GT(plain[law].norm(), 1e-8);
      expectNear(mapped[law], map * plain[law], 1e-9 * plain[law].norm());
    }
  }
}

TEST_F(TriangleForcesTest, ARigidMotionOfTheWholeIsNoCorotatedDeformation) {
  TriangleForces forces(scene, allKinds(), 0.001);
  touchFace(0, -Vec3::UnitY());
  const Mat3 turn = Quat(0.3, 0.8, -0.2, 0.4).normalized().toRotationMatrix();
  for (std::size_t i = 0; i < state.positions_m.size(); ++i) {
    const Vec3& rest_m = scene.bodies[0].rest.vertices_m[i];
    state.positions_m[i] = turn * rest_m + Vec3(0.1, -0.2, 0.3);
    state.velocities_m_s[i] = Vec3(3, -2, 1) + Vec3(20, 30, -10).cross(turn * rest_m);
  }
  forces.evaluate(patch, state);
  for (std::size_t law = 0; law < 8; ++law) {
    const bool corotated = law >= 4;
    EXPECT_EQ(state.forces[law].deformation_max_m < 1e-15, corotated);
    EXPECT_EQ(std::abs(state.forces[law].rate_max_m_s) < 1e-11, corotated);
    EXPECT_EQ(state.forces[law].force_on_tool_N.norm() < 1e-13, corotated);
  }
}

// A deformed box that turns and moves as a whole: the deformation stays, and grows at no rate, by both
// sources.
TEST_F(TriangleForcesTest, TurningWhileDeformedIsNoCorotatedRate) {
  TriangleForces forces(scene, allKinds(), 0.001);
  touchFace(0, -Vec3::UnitY());
  const Vec3 spin_rad_s(20, 30, -10);
  for (int step = 0; step < 3; ++step) {
    const Mat3 turn =
        Eigen::AngleAxisd(0.001 * step * spin_rad_s.norm(), spin_rad_s.normalized()).toRotationMatrix();
    for (std::size_t i = 0; i < state.positions_m.size(); ++i) {
      Vec3 deformed_m = scene.bodies[0].rest.vertices_m[i];
      if (deformed_m.y() > 0) deformed_m.y() -= 0.002 + 0.1 * deformed_m.x();
      state.positions_m[i] = turn * deformed_m + 0.001 * step * Vec3(3, -2, 1);
      state.velocities_m_s[i] = Vec3(3, -2, 1) + spin_rad_s.cross(turn * deformed_m);
    }
    forces.evaluate(patch, state);
  }
  for (std::size_t law = 4; law < 8; ++law) {
    EXPECT_GT(state.forces[law].deformation_max_m, 0.0005);
    EXPECT_LT(std::abs(state.forces[law].rate_max_m_s), 1e-11);
    EXPECT_LT(std::abs(state.forces[law].rate_min_m_s), 1e-11);
  }
  EXPECT_GT(std::abs(state.forces[0].rate_max_m_s), 1) << "of the paper's kind it is";
}

// While the box deforms and turns, both sources must tell the same corotated rate, up to the step.
TEST_F(TriangleForcesTest, CorotatedRatesByVelocitiesAreTheDerivative) {
  const double dt_s = 1e-6;
  TriangleForces forces(scene, allKinds(), dt_s);
  touchFace(0, -Vec3::UnitY());
  for (int step = 0; step < 2; ++step) {
    for (std::size_t i = 0; i < state.positions_m.size(); ++i) {
      const double v = static_cast<double>(i);
      const Vec3 velocity_m_s(0.2 * v, -1 + 0.01 * v * v, 0.3 * std::sin(v));
      state.velocities_m_s[i] = velocity_m_s;
      state.positions_m[i] = scene.bodies[0].rest.vertices_m[i] + (0.003 + step * dt_s) * velocity_m_s;
    }
    forces.evaluate(patch, state);
  }
  for (const std::size_t kind : {0, 4}) {
    EXPECT_GT(std::abs(state.forces[kind].rate_mean_m_s), 0.01);
    EXPECT_NEAR(state.forces[kind].rate_mean_m_s, state.forces[kind + 2].rate_mean_m_s, 1e-4);
    EXPECT_NEAR(state.forces[kind].rate_max_m_s, state.forces[kind + 2].rate_max_m_s, 1e-4);
  }
}

TEST_F(TriangleForcesTest, FitsOnceAStepAndOnlyForCorotatedLaws) {
  for (Vec3& p : state.positions_m) p += Vec3(0, -0.005, 0);
  touchFace(0, -Vec3::UnitY());
  TriangleForces paper = forces();
  TriangleForces all(scene, allKinds(), 0.001);
  for (int step = 0; step < 5; ++step) {
    paper.evaluate(patch, state);
    all.evaluate(patch, state);
  }
  EXPECT_EQ(paper.rigidFits(), 0);
  EXPECT_EQ(all.rigidFits(), 5) << "one body, four corotated laws";
}

// 5 mm, 2 mm down on opposite faces; the box has 12 triangles, of which some meet a touched vertex.
TEST_F(TriangleForcesTest, StatisticsAreOverTheCollidingTrianglesAndZeroWithoutOne) {
  TriangleForces evaluated = forces();
  evaluated.evaluate(patch, state);
  EXPECT_TRUE(state.colliding_triangles.empty() && state.triangle_forces_N.empty());
  EXPECT_EQ(state.forces[0].deformation_max_m, 0);
  EXPECT_EQ(state.forces[0].deformation_mean_m, 0);
  EXPECT_EQ(state.forces[0].rate_min_m_s, 0);
  touchFace(0, -Vec3::UnitY());
  double max_m = 0, sum_m = 0;
  std::vector<int> colliding;
  const std::vector<Vec3> rest_m = state.positions_m;
  for (std::size_t i = 0; i < rest_m.size(); ++i)
    state.positions_m[i] -= Vec3(0, 0.001 * static_cast<double>(i + 1), 0);
  for (const Face& face : scene.bodies[0].rest.faces) {
    if (!patch.vertex_contact[face[0]] && !patch.vertex_contact[face[1]] && !patch.vertex_contact[face[2]])
      continue;
    colliding.push_back(static_cast<int>(&face - scene.bodies[0].rest.faces.data()));
    const double x_m = 0.001 * (face[0] + face[1] + face[2] + 3) / 3;
    max_m = std::max(max_m, x_m);
    sum_m += x_m;
  }
  const double triangles = static_cast<double>(colliding.size());
  evaluated.evaluate(patch, state);
  EXPECT_EQ(state.colliding_triangles, colliding);
  EXPECT_NEAR(state.forces[2].deformation_max_m, max_m, 1e-15);
  EXPECT_NEAR(state.forces[2].deformation_mean_m, sum_m / triangles, 1e-15);
  EXPECT_NEAR(state.forces[2].rate_max_m_s, max_m / 0.001, 1e-9) << "all of it within this step of 1 ms";
  EXPECT_NEAR(state.forces[2].rate_mean_m_s, sum_m / triangles / 0.001, 1e-9);
  EXPECT_GT(state.forces[2].rate_min_m_s, 0);
  EXPECT_EQ(state.forces[0].rate_max_m_s, 0) << "the engine says that nothing moves";
  for (std::size_t i = 0; i < rest_m.size(); ++i) state.positions_m[i] += Vec3(0, 0.0005, 0);
  evaluated.evaluate(patch, state);
  EXPECT_NEAR(state.forces[2].rate_min_m_s, -0.5, 1e-9);
  EXPECT_NEAR(state.forces[2].rate_max_m_s, -0.5, 1e-9) << "all recede";
}

// The box is 20 mm wide: each triangle half a face.
TEST_F(TriangleForcesTest, KeepsWhatEachLawSawOfEachTriangleOnRequest) {
  for (std::size_t i = 0; i < state.positions_m.size(); ++i)
    state.positions_m[i] -= Vec3(0, 0.001 * static_cast<double>(i + 1), 0);
  for (Vec3& v : state.velocities_m_s) v = Vec3(0, -0.2, 0);
  touchFace(0, Vec3(0, -0.6, 0.8));
  forces().evaluate(patch, state);
  EXPECT_EQ(state.law_inputs.capacity(), 0u);
  forces(true).evaluate(patch, state);
  const std::size_t triangles = state.colliding_triangles.size();
  ASSERT_GT(triangles, 1u);
  ASSERT_EQ(state.law_inputs.size(), 3 * triangles);
  const auto law = ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3});
  for (std::size_t i = 0; i < triangles; ++i) {
    const Face& face = scene.bodies[0].rest.faces[state.colliding_triangles[i]];
    const LawInput &by_velocities = state.law_inputs[3 * i], &by_differences = state.law_inputs[3 * i + 2];
    EXPECT_NEAR(by_velocities.deformation_m, 0.001 * (face[0] + face[1] + face[2] + 3) / 3, 1e-15);
    EXPECT_NEAR(by_velocities.rate_m_s, 0.2, 1e-12);
    EXPECT_NEAR(by_differences.rate_m_s, by_differences.deformation_m / 0.001, 1e-9);
    EXPECT_NEAR(by_velocities.area_m2, 2e-4, 1e-15);
    EXPECT_LE((by_velocities.direction - Vec3(0, 0.6, -0.8)).norm(), 1e-15) << "on the tool";
    const LawForce force = law.at(by_differences.deformation_m, by_differences.rate_m_s);
    const Vec3 expected_N = (force.elastic_N + force.viscous_N) * by_differences.direction;
    EXPECT_LE((state.triangle_forces_N[3 * i + 2] - expected_N).norm(), 1e-12 * expected_N.norm());
  }
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
  for (Vec3& v : patch.tools[0].face_normals) mirror(v);
  for (Vec3& v : patch.tools[0].vertex_normals) mirror(v);
  forces().evaluate(patch, state);
  EXPECT_NEAR((state.forces[0].force_on_tool_N - Vec3(-force.x(), force.y(), force.z())).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace fissure::triangle_forces_test
