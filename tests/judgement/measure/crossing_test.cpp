// Crossings of samples and triangles that both move far: none is missed, and few triangles are looked at.
#include "surface/crossing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::crossing_test {

namespace {

TreeTriangle at(const TreeTriangle& before, const TreeTriangle& now, double time) {
  return {(1 - time) * before.a + time * now.a, (1 - time) * before.b + time * now.b,
          (1 - time) * before.c + time * now.c};
}

/// Times at which a point meets one triangle, from signs of the volume between them at many times; `margin`:
/// how far inside the triangle (as a share of its area) it must be.
std::vector<double> meetings(const TreeTriangle& before, const TreeTriangle& now, const Vec3& from,
                             const Vec3& to, double margin) {
  constexpr int kTimes = 512;
  const auto point = [&](double time) { return Vec3((1 - time) * from + time * to); };
  const auto volume = [&](double time) {
    const TreeTriangle t = at(before, now, time);
    return t.doubleAreaNormal().dot(point(time) - t.a);
  };
  std::vector<double> times;
  for (int i = 0; i < kTimes; ++i) {
    double low = static_cast<double>(i) / kTimes, high = static_cast<double>(i + 1) / kTimes;
    const bool below = volume(low) > 0;
    if (below == (volume(high) > 0)) continue;
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = (low + high) / 2;
      (volume(middle) > 0) == below ? low = middle : high = middle;
    }
    const TreeTriangle t = at(before, now, low);
    const Vec3 p = point(low), normal = t.doubleAreaNormal();
    const auto share = [&](const Vec3& a, const Vec3& b) {
      return (b - a).cross(p - a).dot(normal) / normal.squaredNorm();
    };
    if (std::min({share(t.a, t.b), share(t.b, t.c), share(t.c, t.a)}) > margin) times.push_back(low);
  }
  return times;
}

/// Vertices that go by up to `far` each, and all together by up to ten times that.
std::vector<Vec3> thrown(const std::vector<Vec3>& vertices, double far_m, std::mt19937& random) {
  const Vec3 way = test::randomIn(random, 10 * far_m);
  std::vector<Vec3> moved;
  for (const Vec3& vertex : vertices) moved.push_back(vertex + way + test::randomIn(random, far_m));
  return moved;
}

TEST(Crossings, OfThrownTissueNoneIsMissedAndNoneIsMadeUp) {
  std::mt19937 random(7);
  const TriangleMesh ball = makeSphere(0.03, 1);
  std::size_t found_in_all = 0;
  for (int round = 0; round < 900; ++round) {
    SurfaceTree tree(ball);
    const double far_m = round % 3 == 0 ? 0 : round % 3 == 1 ? 0.003 : 0.02;
    tree.update(thrown(ball.vertices_m, far_m, random));
    const Vec3 from = test::randomIn(random, 0.04),
               to = from + test::randomIn(random, round % 2 ? 0.2 : 0.02);
    std::vector<Crossing> found;
    findCrossings(tree, from, to, found);
    std::vector<double> surely, perhaps;
    for (std::size_t i = 0; i < tree.triangles().size(); ++i) {
      for (const double time : meetings(tree.previous()[i], tree.triangles()[i], from, to, 1e-6))
        surely.push_back(time);
      for (const double time : meetings(tree.previous()[i], tree.triangles()[i], from, to, -1e-6))
        perhaps.push_back(time);
    }
    const auto isNear = [](double time) {
      return [time](const auto& other) {
        if constexpr (requires { other.time; })
          return std::abs(other.time - time) < 1e-9;
        else
          return std::abs(other - time) < 1e-9;
      };
    };
    for (const double time : surely)
      EXPECT_TRUE(std::any_of(found.begin(), found.end(), isNear(time))) << round << " at " << time;
    // Two meetings within one of the oracle's times are none to it.
    long long made_up = 0;
    for (const Crossing& crossing : found)
      made_up += std::none_of(perhaps.begin(), perhaps.end(), isNear(crossing.time));
    EXPECT_EQ(made_up % 2, 0) << round;
    EXPECT_LE(made_up, 2) << round;
    found_in_all += surely.size();
  }
  EXPECT_GT(found_in_all, 200u);
}

// A ball of 50 mm within tissue that is thrown to and fro by 40 mm a step, as it is where it is pushed out of
// a tool at once.
TEST(Crossings, OfThrownTissueFewTrianglesAreLookedAt) {
  Scene scene = test::makeScene({makeSphere(0.04, 4)}, {Vec3(0.01, 0.01, 0.01)});
  scene.tools[0].surface = makeSphere(0.025, 3);
  scene.tools[0].box_size_m.reset();
  PenetrationMeter meter(scene, {0.002});
  State state = test::restState(scene, {test::at(0, 0, 0)});
  meter.measure(state);
  std::mt19937 random(3);
  const std::vector<Vec3> rest_m = state.positions_m;
  const int steps = 20;
  const long long before = meter.crossingTests();
  for (int step = 0; step < steps; ++step) {
    const Vec3 way(step % 2 == 0 ? 0.04 : 0, 0.002 * step, 0);
    for (std::size_t i = 0; i < rest_m.size(); ++i)
      state.positions_m[i] = rest_m[i] + way + test::randomIn(random, 0.0005);
    EXPECT_GT(meter.measure(state).depth_m, 0.005);
  }
  const auto looks = static_cast<double>(meter.crossingTests() - before);
  EXPECT_LT(looks, 2.0 * steps * static_cast<double>(meter.sampleCount()));
}

}  // namespace
}  // namespace fissure::crossing_test
