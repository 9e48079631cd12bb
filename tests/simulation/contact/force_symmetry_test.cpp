// The force of every kind of law and deformation turns, mirrors and scales with the scene.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "contact/triangle_forces.h"
#include "mesh/primitives.h"

namespace fissure::force_symmetry_test {

namespace {

/// Hunt-Crossley, Kelvin-Voigt and linear, each by both deformations, both rate sources, a triangle and per
/// area: 24 laws.
std::vector<TriangleLaw> allLaws() {
  std::vector<TriangleLaw> laws;
  for (const DeformationKind kind : {DeformationKind::paper, DeformationKind::corotated}) {
    for (const RateSource rate : {RateSource::differences, RateSource::velocities}) {
      for (const bool per_area : {false, true}) {
        laws.push_back(
            {ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3}), rate, kind, per_area});
        laws.push_back({ForceLaw(ForceModel::kelvin_voigt, {.k = 300, .c = 2}), rate, kind, per_area});
        laws.push_back({ForceLaw(ForceModel::linear_elastic, {.k = 100}), rate, kind, per_area});
      }
    }
  }
  return laws;
}

using Map = std::function<Vec3(const Vec3&)>;

/// Two bodies with two tools: deformed and moving in no particular way, mapped by `map` (positions) and
/// `turn` (directions and velocities) before anything looks at them.
class Play {
 public:
  Play(const Map& map, const Mat3& turn, std::vector<TriangleMesh> bodies)
      : map_(map), turn_(turn), rest_(std::move(bodies)) {
    for (TriangleMesh mesh : rest_) {
      for (Vec3& v : mesh.vertices_m) v = map_(v);
      scene_.bodies.push_back({.name = "body",
                               .rest = mesh,
                               .first_vertex = scene_.vertexCount(),
                               .first_face = scene_.faceCount()});
    }
    scene_.tools.resize(2);
    patch_.resize(scene_.vertexCount(), scene_.faceCount(), 2);
    patch_.clear();
    touch(0, 3, Vec3(0.6, -0.8, 0), 0.001);
    touch(1, 3, Vec3(0, -0.6, 0.8), 0.003);
    touch(1, 40, Vec3(0, 0, 1), 0.002);
    touch(0, 130, Vec3(-0.8, 0, 0.6), 0.002);
  }

  /// On each tool, law by law, after three steps.
  State run(std::vector<TriangleLaw> laws) {
    TriangleForces forces(scene_, std::move(laws), 0.001);
    State state;
    for (int step = 1; step <= 3; ++step) {
      state.positions_m.clear();
      state.velocities_m_s.clear();
      for (const TriangleMesh& mesh : rest_) {
        for (const Vec3& rest_m : mesh.vertices_m) {
          const Vec3 wave(std::sin(90 * rest_m.y()), std::cos(70 * rest_m.z()),
                          std::sin(50 * rest_m.x() + 1));
          state.positions_m.push_back(map_(rest_m + (0.004 + 0.0002 * step) * wave));
          state.velocities_m_s.push_back(turn_ * (0.15 * wave + Vec3(0.02, 0, 0.01)));
        }
      }
      forces.evaluate(patch_, state);
    }
    return state;
  }

 private:
  void touch(int tool, int face, const Vec3& normal, double displacement_m) {
    patch_.touchFace(tool, face, turn_ * normal, displacement_m);
    const SceneBody& body = scene_.bodies[face < scene_.bodies.back().first_face ? 0 : 1];
    double weight = 0.2;
    for (const int vertex : body.rest.faces[static_cast<std::size_t>(face - body.first_face)]) {
      patch_.touchVertex(tool, vertex + body.first_vertex, weight, turn_ * normal, displacement_m);
      weight += 0.2;
    }
  }

  Map map_;
  Mat3 turn_;
  std::vector<TriangleMesh> rest_;
  Scene scene_;
  ContactPatch patch_;
};

std::vector<TriangleMesh> twoBodies() {
  TriangleMesh other = makeSphere(0.02, 1);
  for (Vec3& v : other.vertices_m) v += Vec3(0.05, 0.01, 0);
  return {makeSphere(0.03, 2), other};
}

TEST(ForceSymmetry, OnEveryToolEveryLawTurnsAndMirrorsWithTheScene) {
  const Mat3 none = Mat3::Identity();
  const State plain = Play([](const Vec3& p) { return p; }, none, twoBodies()).run(allLaws());
  ASSERT_EQ(plain.forces.size(), 24u);
  const Mat3 turn = Quat(0.5, 0.1, -0.7, 0.5).normalized().toRotationMatrix();
  const Mat3 half_turn = Vec3(-1, -1, 1).asDiagonal();
  const Mat3 mirror = Vec3(1, 1, -1).asDiagonal();
  const Mat3 invert = -none;
  for (const Mat3& map : {turn, half_turn, mirror, invert, Mat3(turn * mirror)}) {
    const Vec3 shift_m(0.3, -0.2, 0.5);
    const State mapped =
        Play([&](const Vec3& p) { return Vec3(map * p + shift_m); }, map, twoBodies()).run(allLaws());
    EXPECT_EQ(mapped.colliding_triangles, plain.colliding_triangles);
    for (std::size_t law = 0; law < plain.forces.size(); ++law) {
      EXPECT_NEAR(mapped.forces[law].elastic_N / plain.forces[law].elastic_N, 1, 1e-9) << law;
      EXPECT_EQ(mapped.forces[law].adhesion_clamped, plain.forces[law].adhesion_clamped) << law;
      for (std::size_t tool = 0; tool < 2; ++tool) {
        const Vec3& force_N = plain.tool_forces_N[2 * law + tool];
        const Vec3& found_N = mapped.tool_forces_N[2 * law + tool];
        EXPECT_GT(force_N.norm(), 1e-7) << law;
        EXPECT_LE((found_N - map * force_N).norm(), 1e-9 * force_N.norm())
            << "law " << law << ", tool " << tool;
      }
    }
  }
}

// Lengths, displacements and velocities times s: x^n grows by s^n, x^n x' by s^(n+1), and per area by s^2
// more.
TEST(ForceSymmetry, ForcesScaleWithTheSceneByTheExponentsOfTheirLaws) {
  const auto run = [](double s) {
    return Play([s](const Vec3& p) { return Vec3(s * p); }, s * Mat3::Identity(), twoBodies()).run(allLaws());
  };
  const State one = run(1);
  int compared = 0;
  for (const double s : {0.1, 3.0}) {
    const State scaled = run(s);
    for (std::size_t law = 0; law < one.forces.size(); ++law) {
      if (one.forces[law].adhesion_clamped > 0 || scaled.forces[law].adhesion_clamped > 0) continue;
      ++compared;
      const double n = law % 3 == 0 ? 1.3 : 1.0;  // then Kelvin-Voigt, whose c x' is of order 1 too
      const double area = law / 3 % 2 == 1 ? 2 : 0;
      EXPECT_NEAR(scaled.forces[law].elastic_N / one.forces[law].elastic_N, std::pow(s, n + area),
                  1e-9 * std::pow(s, n + area))
          << "law " << law;
      if (law % 3 == 2) continue;
      const double rate = law % 3 == 0 ? n + 1 : 1;
      EXPECT_NEAR(scaled.forces[law].viscous_N / one.forces[law].viscous_N, std::pow(s, rate + area),
                  1e-9 * std::pow(s, rate + area))
          << "law " << law;
    }
  }
  EXPECT_GE(compared, 40) << "clamped forces do not scale";
}

/// Each triangle in four, by the middles of its edges, all in its plane.
TriangleMesh refined(const TriangleMesh& mesh) {
  TriangleMesh fine;
  for (const Face& face : mesh.faces) {
    const int first = static_cast<int>(fine.vertices_m.size());
    const auto corner = [&](std::size_t i) { return mesh.vertices_m[static_cast<std::size_t>(face[i % 3])]; };
    for (std::size_t i = 0; i < 3; ++i) fine.vertices_m.push_back(corner(i));
    for (std::size_t i = 0; i < 3; ++i) fine.vertices_m.push_back((corner(i) + corner(i + 1)) / 2);
    fine.faces.push_back({first, first + 3, first + 5});
    fine.faces.push_back({first + 3, first + 1, first + 4});
    fine.faces.push_back({first + 5, first + 4, first + 2});
    fine.faces.push_back({first + 3, first + 4, first + 5});
  }
  return fine;
}

// All tissue displaced alike and in contact: four triangles for one give four times the force, per area the
// same; and per area it is law times the whole area.
TEST(ForceSymmetry, PerAreaDoesNotKnowHowFineTheTrianglesAre) {
  const auto run = [](const TriangleMesh& mesh) {
    Scene scene;
    scene.bodies.push_back({.name = "body", .rest = mesh});
    scene.tools.resize(1);
    ContactPatch patch;
    patch.resize(scene.vertexCount(), scene.faceCount(), 1);
    patch.clear();
    State state;
    for (int v = 0; v < scene.vertexCount(); ++v) {
      patch.touchVertex(0, v, 1, -Vec3::UnitY(), 0.001);
      state.positions_m.push_back(mesh.vertices_m[static_cast<std::size_t>(v)] - Vec3(0, 0.005, 0));
      state.velocities_m_s.push_back(Vec3(0, -0.2, 0));
    }
    std::vector<TriangleLaw> laws;
    for (const bool per_area : {false, true})
      laws.push_back({ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3}),
                      RateSource::velocities, DeformationKind::paper, per_area});
    TriangleForces(scene, std::move(laws), 0.001).evaluate(patch, state);
    return std::pair(state.forces[0].force_on_tool_N.y(), state.forces[1].force_on_tool_N.y());
  };
  const TriangleMesh box = makeBox({0.02, 0.03, 0.04});
  const double area_m2 = 2 * (0.02 * 0.03 + 0.03 * 0.04 + 0.04 * 0.02);
  const double law_N = (200 + 50 * 0.2) * std::pow(0.005, 1.3);
  const auto [coarse_N, coarse_per_area_N] = run(box);
  const auto [fine_N, fine_per_area_N] = run(refined(refined(box)));
  EXPECT_NEAR(coarse_N, 12 * law_N, 1e-12);
  EXPECT_NEAR(fine_N, 16 * coarse_N, 1e-11);
  EXPECT_NEAR(coarse_per_area_N, area_m2 * law_N, 1e-14);
  EXPECT_NEAR(fine_per_area_N, area_m2 * law_N, 1e-14);
}

}  // namespace
}  // namespace fissure::force_symmetry_test
