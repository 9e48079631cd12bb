// Penetration against an independent slow measurement, closed forms and invariants.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "slow_penetration.h"
#include "surface/oracles.h"

namespace fissure::penetration_oracle_test {

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int kShare = 6;
#else
constexpr int kShare = 1;
#endif

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Vec3 kBlade(0.04, 0.002, 0.015);

/// Box tools of all kinds: spatula, rod, needle, plate, cube and a foil.
const std::vector<Vec3>& toolSizes() {
  static const std::vector<Vec3> sizes = {kBlade,
                                          {0.004, 0.06, 0.004},
                                          {0.0005, 0.0005, 0.08},
                                          {0.06, 0.005, 0.06},
                                          {0.012, 0.012, 0.012},
                                          {0.02, 0.00002, 0.03}};
  return sizes;
}

TriangleMesh dented(TriangleMesh mesh, double by_m) {
  for (Vec3& v : mesh.vertices_m)
    if (v.y() > 0) v.y() -= by_m * std::exp(-(v.x() * v.x() + v.z() * v.z()) / 1e-4);
  return mesh;
}

/// Deformed spheres of 66 vertices: as it is, dented, squashed, twisted, crumpled, and dented through its
/// own bottom.
std::vector<TriangleMesh> tissues() {
  const TriangleMesh sphere = makeSphere(0.03, 2);
  TriangleMesh squashed = sphere, twisted = sphere;
  for (Vec3& v : squashed.vertices_m) v = Vec3(1.3, 0.3, 1.2).cwiseProduct(v);
  for (Vec3& v : twisted.vertices_m) v = Eigen::AngleAxisd(40 * v.y(), Vec3::UnitY()) * v;
  return {sphere,
          dented(sphere, 0.02),
          squashed,
          twisted,
          test::crumpledSphere(0.03, 2, 0.15, 3),
          test::crumpledSphere(0.03, 2, 0.6, 4),
          dented(sphere, 0.08)};
}

double spacingFor(const Vec3& size_m) {
  return size_m.maxCoeff() / 7;
}

/// The scene's state with its bodies deformed into `now`.
State stateOf(const Scene& scene, const std::vector<TriangleMesh>& now, const std::vector<Pose>& tools) {
  State state = test::restState(scene, tools);
  state.positions_m.clear();
  for (const TriangleMesh& mesh : now)
    state.positions_m.insert(state.positions_m.end(), mesh.vertices_m.begin(), mesh.vertices_m.end());
  return state;
}

void expectAsSlowly(const Scene& scene, const std::vector<TriangleMesh>& now, const std::vector<Pose>& tools,
                    double spacing_m, test::SlowPenetration& slow) {
  slow = {.gap_m = kInfinity};
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const ToolSamples samples = makeToolSamples(scene, scene.tools[t], spacing_m);
    for (const TriangleMesh& body : now)
      test::measureSlowly(body, *scene.tools[t].box_size_m, tools[t], samples.points_m, slow);
  }
  const Penetration found = PenetrationMeter(scene, {spacing_m}).measure(stateOf(scene, now, tools));
  ASSERT_NEAR(found.depth_m, slow.depth_m, 1e-13);
  if (slow.odd_samples > 0) {
    ASSERT_GT(found.inverted_triangles, 0) << "depth hides in folded tissue";
  }
  if (slow.depth_m > 0 || slow.gap_m >= kStandOffLimit_m) {
    ASSERT_TRUE(std::isnan(found.stand_off_m));
  } else {
    ASSERT_NEAR(found.stand_off_m, slow.gap_m, 1e-13);
  }
}

TEST(PenetrationOracle, AgreesOnRandomPosesInDeformedTissue) {
  std::mt19937 random(61);
  int deep = 0, gaps = 0, odd = 0;
  for (const TriangleMesh& tissue : tissues()) {
    for (const Vec3& size_m : toolSizes()) {
      const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {size_m});
      for (int i = 0; i < 12 / kShare; ++i) {
        const Pose pose = test::randomPose(random, i % 3 == 0 ? 0.06 : 0.03);
        test::SlowPenetration slow;
        expectAsSlowly(scene, {tissue}, {pose}, spacingFor(size_m), slow);
        if (testing::Test::HasFatalFailure()) return;
        deep += slow.depth_m > 0.001;
        gaps += slow.depth_m == 0 && slow.gap_m < kStandOffLimit_m;
        odd += slow.odd_samples > 0;
      }
    }
  }
  EXPECT_GT(deep, 200 / kShare);
  EXPECT_GT(gaps, 20 / kShare);
  EXPECT_GT(odd, 6 / kShare);
}

// Two tools in three bodies of which two overlap: the worst over all pairs, the gap the least.
TEST(PenetrationOracle, AgreesWithSeveralBodiesAndTools) {
  std::mt19937 random(62);
  const std::vector<TriangleMesh> rest = {makeSphere(0.02, 2), makeBox({0.03, 0.02, 0.03}),
                                          test::moved(makeSphere(0.02, 1), test::at(0.05, 0, 0))};
  const Scene scene = test::makeScene(rest, {{0.012, 0.001, 0.008}, {0.004, 0.03, 0.004}});
  for (int i = 0; i < 60 / kShare; ++i) {
    std::vector<TriangleMesh> now;
    for (const TriangleMesh& mesh : rest) now.push_back(test::moved(mesh, test::randomPose(random, 0.02)));
    test::SlowPenetration slow;
    expectAsSlowly(scene, now, {test::randomPose(random, 0.05), test::randomPose(random, 0.05)}, 0.003, slow);
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// Planes of a convex body's triangles: normal . p <= offset inside.
struct Planes {
  explicit Planes(const TriangleMesh& mesh) {
    for (const Face& face : mesh.faces) {
      const auto corner = [&](std::size_t i) { return mesh.vertices_m[static_cast<std::size_t>(face[i])]; };
      normals.push_back((corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized());
      offsets_m.push_back(normals.back().dot(corner(0)));
    }
    for (const Vec3& vertex : mesh.vertices_m) worst_m = std::min(worst_m, depthOf(vertex));
  }
  /// Distance to the surface for a point inside a convex body, negative outside: exact.
  double depthOf(const Vec3& point_m) const {
    double least_m = kInfinity;
    for (std::size_t i = 0; i < normals.size(); ++i)
      least_m = std::min(least_m, offsets_m[i] - normals[i].dot(point_m));
    return least_m;
  }
  std::vector<Vec3> normals;
  std::vector<double> offsets_m;
  double worst_m = 0;  ///< of a vertex in front of some plane: 0 but for rounding when convex
};

/// The largest depth of any point on a box's surface, from below, on a grid `finer` than the samples.
double deepestOnBox_m(const Planes& planes, const Vec3& size_m, const Pose& pose, int points) {
  double deepest_m = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i <= points; ++i) {
      for (int j = 0; j <= points; ++j) {
        Vec3 at_m;
        at_m[(axis + 1) % 3] = size_m[(axis + 1) % 3] * (static_cast<double>(i) / points - 0.5);
        at_m[(axis + 2) % 3] = size_m[(axis + 2) % 3] * (static_cast<double>(j) / points - 0.5);
        for (const double side : {-0.5, 0.5}) {
          at_m[axis] = side * size_m[axis];
          deepest_m = std::max(deepest_m, planes.depthOf(pose.toScene(at_m)));
        }
      }
    }
  }
  return deepest_m;
}

// A box at all angles in a convex polyhedron inscribed in a sphere, fully inside and sticking out. Depth by
// samples is that of planes, which in a convex body is exact; against the whole surface of the tool it is
// short by the samples' coverage at most (a distance changes by no more than the way); and the sphere bounds
// both.
TEST(PenetrationOracle, OfABoxInASphereAtAllAnglesIsThatOfThePlanes) {
  const double radius_m = 0.03;
  const TriangleMesh sphere = makeSphere(radius_m, 2);
  const Planes planes(sphere);
  ASSERT_GT(planes.worst_m, -1e-15) << "not convex: planes would not do";
  std::mt19937 random(63);
  for (const Vec3& size_m : {Vec3(0.012, 0.002, 0.008), kBlade, Vec3(0.003, 0.07, 0.003)}) {
    const Scene scene = test::makeScene({sphere}, {size_m});
    const double spacing_m = spacingFor(size_m) / 2;
    const ToolSamples samples = makeToolSamples(scene, scene.tools[0], spacing_m);
    const int grid = static_cast<int>(2 * size_m.maxCoeff() / spacing_m);
    PenetrationMeter meter(scene, {spacing_m});
    for (int i = 0; i < 60 / kShare; ++i) {
      const Pose pose = test::randomPose(random, 0.01);
      const double found_m = meter.measure(test::restState(scene, {pose})).depth_m;
      double by_planes_m = 0, by_sphere_m = 0;
      for (const Vec3& sample_m : samples.points_m) {
        by_planes_m = std::max(by_planes_m, planes.depthOf(pose.toScene(sample_m)));
        by_sphere_m = std::max(by_sphere_m, radius_m - pose.toScene(sample_m).norm());
      }
      ASSERT_NEAR(found_m, by_planes_m, 1e-15);
      ASSERT_LE(found_m, by_sphere_m);
      ASSERT_GE(found_m, by_sphere_m - (radius_m - planes.depthOf(Vec3::Zero())));
      const double whole_m = deepestOnBox_m(planes, size_m, pose, grid);
      ASSERT_GE(found_m, whole_m - samples.coverage_m);
      ASSERT_GT(found_m, 0.001);
    }
  }
}

/// Whether a straight way leads right through a convex body (Cyrus and Beck 1978): in by one side, before its
/// end out by another that faces the opposite way.
bool leadsThrough(const Planes& planes, const Vec3& from_m, const Vec3& to_m) {
  double enter = 0, leave = kInfinity;
  Vec3 in = Vec3::Zero(), out = Vec3::Zero();
  for (std::size_t i = 0; i < planes.normals.size(); ++i) {
    const double slope = planes.normals[i].dot(to_m - from_m);
    const double time = (planes.offsets_m[i] - planes.normals[i].dot(from_m)) / slope;
    if (slope < 0 && time > enter) enter = time, in = planes.normals[i];
    if (slope > 0 && time < leave) leave = time, out = planes.normals[i];
  }
  return enter < leave && leave < 1 && in.dot(out) < 0;
}

// Tools that go straight in any direction, in one step or in many: exactly those samples have passed whose
// way leads through. Those that went only so far, and then the same way back, have not.
TEST(PenetrationOracle, PassedThroughIsWhatTheChordsSay) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {{0.03, 0.002, 0.02}});
  const Planes planes(scene.bodies[0].rest);
  const ToolSamples samples = makeToolSamples(scene, scene.tools[0], 0.004);
  const long long all = static_cast<long long>(samples.points_m.size());
  std::mt19937 random(64);
  int partly = 0, in_and_out = 0;
  for (int i = 0; i < 90 / kShare; ++i) {
    const Quat turn = test::randomRotation(random);
    const Vec3 half_way_m = 0.09 * (test::randomRotation(random) * Vec3::UnitX());
    const Vec3 from_m = test::randomIn(random, 0.02) - half_way_m;
    const Vec3 to_m = from_m + (i % 3 == 0 ? 2.0 : 1.0) * half_way_m;
    long long expected = 0;
    for (const Vec3& sample_m : samples.points_m)
      expected += leadsThrough(planes, from_m + turn * sample_m, to_m + turn * sample_m);
    for (const int steps : {1, 6, 45}) {
      PenetrationMeter meter(scene, {0.004});
      double deepest_m = 0;
      for (int step = 0; step <= 2 * steps; ++step) {
        const double way = 1 - std::abs(static_cast<double>(step) / steps - 1);
        const Penetration found =
            meter.measure(test::restState(scene, {{from_m + way * (to_m - from_m), turn}}));
        deepest_m = std::max(deepest_m, found.depth_m);
        if (step < steps) continue;
        ASSERT_EQ(found.passed_through, expected) << steps << " steps, of which " << step;
      }
      in_and_out += expected == 0 && deepest_m > 0.005;
    }
    partly += expected > 0 && expected < all;
  }
  EXPECT_GT(partly, 25 / kShare);
  EXPECT_GT(in_and_out, 25 / kShare);
}

}  // namespace
}  // namespace fissure::penetration_oracle_test
