#include "contact/swept_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "mesh/primitives.h"
#include "slow_distance.h"

namespace fissure::swept_pairs_test {

namespace {

constexpr double kReach_m = 0.002;
constexpr double kSeparation_m = 1e-5;
constexpr double kClearly_m = 5e-5;

TriangleMesh placed(TriangleMesh mesh, const Pose& pose) {
  for (Vec3& v : mesh.vertices_m) v = pose.toScene(v);
  return mesh;
}

SceneTool toolOf(TriangleMesh surface, bool closed = true) {
  SceneTool tool;
  tool.surface = std::move(surface);
  tool.closed = closed;
  return tool;
}

/// A tissue of 32 triangles beside a box, anew for each seed, and the way of each of its vertices.
struct Scene {
  explicit Scene(unsigned seed) : random(seed) {
    tool = toolOf(makeBox(Vec3(0.01, 0.004, 0.006)));
    body.rest = placed(makeSphere(0.004, 1),
                       {.position_m = 0.01 * direction(),
                        .orientation = Quat(Eigen::AngleAxisd(3 * uniform(random), direction()))});
    for (Vec3& v : body.rest.vertices_m) v += 0.0003 * direction();
    const Vec3 way = 0.006 * direction();
    for (const Vec3& v : body.rest.vertices_m) to_m.push_back(v + way + 0.002 * direction());
  }
  Vec3 direction() { return Vec3(uniform(random), uniform(random), uniform(random)).normalized(); }
  TriangleMesh at(double time) const {
    TriangleMesh mesh = body.rest;
    for (std::size_t v = 0; v < to_m.size(); ++v) mesh.vertices_m[v] += time * (to_m[v] - mesh.vertices_m[v]);
    return mesh;
  }
  TissuePath path() const { return {body.rest.vertices_m, to_m}; }

  double longestWay_m() const {
    double longest_m = 0;
    for (std::size_t v = 0; v < to_m.size(); ++v)
      longest_m = std::max(longest_m, (to_m[v] - body.rest.vertices_m[v]).norm());
    return longest_m;
  }

  std::mt19937 random;
  std::uniform_real_distribution<double> uniform{-1, 1};
  SceneTool tool;
  SceneBody body;
  std::vector<Vec3> to_m;
};

double distanceOf(const SweptPair& pair, std::span<const Vec3> at_m) {
  Vec3 point = Vec3::Zero();
  for (int j = 0; j < 3; ++j) point += pair.weights[j] * at_m[pair.vertices[j]];
  EXPECT_NEAR((point - pair.tool_point_m).normalized().dot(pair.normal), 1, 1e-9);
  return (point - pair.tool_point_m).norm();
}

TEST(NearPairs, HoldTheLeastDistanceOfBothSurfacesAndNoneBelowIt) {
  int near = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Scene scene(seed);
    SweptPairs pairs(scene.tool, scene.body);
    if (pairs.overlap(scene.body.rest.vertices_m)) continue;
    const TissuePath still{scene.body.rest.vertices_m, scene.body.rest.vertices_m};
    pairs.gather(still, kReach_m);
    std::vector<SweptPair> found;
    pairs.findNear(still, kReach_m, found);
    const double least_m = test::slowDistance_m(scene.body.rest, scene.tool.surface);
    ASSERT_EQ(found.empty(), least_m >= kReach_m) << seed;
    if (found.empty()) continue;
    ++near;
    double nearest_m = kReach_m;
    for (const SweptPair& pair : found) {
      nearest_m = std::min(nearest_m, distanceOf(pair, still.from_m));
      EXPECT_EQ(std::count_if(found.begin(), found.end(),
                              [&](const SweptPair& other) { return pair.sameFeatures(other); }),
                1)
          << "each pair once";
    }
    EXPECT_NEAR(nearest_m, least_m, 1e-12) << seed;
  }
  EXPECT_GT(near, 30) << "no pairs, no test";
}

// Against the distance at 400 times of the path: what comes nearer than the separation at one of them is
// found, and what stays clearly farther is not.
TEST(CrossingPairs, AreFoundWhereSurfacesMeetOnThePath) {
  int met = 0, passed = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Scene scene(seed);
    SweptPairs pairs(scene.tool, scene.body);
    if (pairs.overlap(scene.body.rest.vertices_m)) continue;
    pairs.gather(scene.path(), kSeparation_m);
    std::vector<SweptPair> found;
    pairs.findCrossings(scene.path(), kSeparation_m, found);
    double least_m = 1, met_at = 2;
    for (int i = 0; i <= 400 && met_at > 1;) {
      const TriangleMesh tissue = scene.at(i / 400.0);
      const double distance_m =
          pairs.overlap(tissue.vertices_m) ? 0 : test::slowDistance_m(tissue, scene.tool.surface);
      least_m = std::min(least_m, distance_m);
      if (distance_m < kSeparation_m) met_at = i / 400.0;
      // Until then it stays clearly farther, because no point moves faster than the fastest vertex.
      i += std::max(1, static_cast<int>((distance_m - kClearly_m) / (scene.longestWay_m() / 400)));
    }
    if (met_at <= 1) {
      ++met;
      ASSERT_FALSE(found.empty()) << seed;
      double first = 1;
      for (const SweptPair& pair : found) first = std::min(first, pair.time);
      EXPECT_LE(first, met_at) << seed;
      EXPECT_GT(first, met_at - 0.05) << seed;
    } else if (least_m > kClearly_m) {
      ++passed;
      EXPECT_TRUE(found.empty()) << seed;
    }
  }
  EXPECT_GT(met, 20);
  EXPECT_GT(passed, 20);
}

// After a few vertices have gone another way, looking again at what moved finds what looking at all does.
TEST(CrossingPairs, AreTheSameWhenOnlyWhatMovedIsLookedAtAgain) {
  int found_some = 0, changed = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    Scene scene(seed);
    SweptPairs again(scene.tool, scene.body), anew(scene.tool, scene.body);
    again.gather(scene.path(), kReach_m);
    std::vector<SweptPair> first, second, expected;
    again.findCrossings(scene.path(), kSeparation_m, first);
    const std::vector<int> moved{1, 4, 7, 1};
    for (const int v : moved) scene.to_m[v] += 0.01 * scene.direction();
    again.gather(scene.path(), kSeparation_m, moved);
    again.findCrossings(scene.path(), kSeparation_m, second);
    anew.gather(scene.path(), kSeparation_m);
    anew.findCrossings(scene.path(), kSeparation_m, expected);
    ASSERT_EQ(second.size(), expected.size()) << seed;
    for (std::size_t i = 0; i < second.size(); ++i) {
      EXPECT_TRUE(second[i].sameFeatures(expected[i])) << seed;
      EXPECT_EQ(second[i].time, expected[i].time) << seed;
    }
    found_some += second.empty() ? 0 : 1;
    changed += first.size() != second.size() ? 1 : 0;
  }
  EXPECT_GT(found_some, 20);
  EXPECT_GT(changed, 20);
}

TEST(CrossingPairs, AreNoneForTissueThatStaysOrLeaves) {
  const SceneTool tool = toolOf(makeBox(Vec3(0.01, 0.002, 0.01)));
  SceneBody body;
  body.rest = placed(makeSphere(0.003, 1), {.position_m = Vec3(0, 0.004 + 1e-6, 0)});
  SweptPairs pairs(tool, body);
  std::vector<Vec3> to_m = body.rest.vertices_m;
  std::vector<SweptPair> found;
  const TissuePath path{body.rest.vertices_m, to_m};
  pairs.gather(path, kSeparation_m);
  pairs.findCrossings(path, kSeparation_m, found);
  EXPECT_TRUE(found.empty()) << "at rest, nearer than the separation";
  for (Vec3& v : to_m) v.y() += 0.001;
  pairs.findCrossings(path, kSeparation_m, found);
  EXPECT_TRUE(found.empty()) << "leaves";
  for (Vec3& v : to_m) v.y() -= 0.001 + 5e-7;
  pairs.findCrossings(path, kSeparation_m, found);
  EXPECT_FALSE(found.empty()) << "comes nearer still";
}

// The rim of a tool under a flat piece of tissue that tilts to either side: the three edges of its lower face
// (with the diagonal) that cross the rim stay pairs with it, however they tilt.
TEST(NearPairs, StayWhereTissueOnARimTilts) {
  const SceneTool tool = toolOf(makeBox(Vec3(0.02, 0.002, 0.02)));
  for (const double degrees : {-20.0, -5.0, -1e-6, 0.0, 1e-6, 5.0, 20.0}) {
    const Quat tilt(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::UnitZ()));
    SceneBody body;
    body.rest = placed(makeBox(Vec3(0.008, 0.004, 0.004)), {.position_m = Vec3(0, 0.002, 0)});
    body.rest = placed(body.rest, {.position_m = Vec3(0.01, 0.0015, 0), .orientation = tilt});
    SweptPairs pairs(tool, body);
    const TissuePath still{body.rest.vertices_m, body.rest.vertices_m};
    std::vector<SweptPair> found;
    pairs.gather(still, kReach_m);
    pairs.findNear(still, kReach_m, found);
    EXPECT_EQ(std::count_if(found.begin(), found.end(),
                            [](const SweptPair& pair) {
                              return pair.kind == PairKind::edge_edge && pair.tool_point_m.x() > 0.0099 &&
                                     pair.tool_point_m.y() > 0.0009;
                            }),
              3)
        << degrees;
  }
}

// Over the diagonal of a box's face, which is no edge, there is one contact as anywhere else.
TEST(NearPairs, AFaceGoesOnBeyondItsFlatEdges) {
  const SceneTool tool = toolOf(makeBox(Vec3(0.02, 0.002, 0.02)));
  SceneBody body;
  for (const Vec3& at :
       {Vec3(0, 0, 0), Vec3(0.003, 0, 0.003), Vec3(0.003, 0, -0.003), Vec3(0.001, 0, 0.002)}) {
    body.rest = placed(makeSphere(0.002, 1), {.position_m = at + Vec3(0, 0.0035, 0)});
    SweptPairs pairs(tool, body);
    const TissuePath still{body.rest.vertices_m, body.rest.vertices_m};
    pairs.gather(still, 0.001);
    std::vector<SweptPair> found;
    pairs.findNear(still, 0.001, found);
    ASSERT_EQ(found.size(), 1u) << at.transpose();
    EXPECT_EQ(found[0].kind, PairKind::vertex_face);
    EXPECT_NEAR((found[0].normal - Vec3::UnitY()).norm(), 0, 1e-12);
  }
}

// A sheet without thickness has two sides.
TEST(NearPairs, OfASheetPointToWhereTissueIs) {
  const SceneTool tool = toolOf(
      {{{-0.01, 0, -0.01}, {0.01, 0, -0.01}, {0.01, 0, 0.01}, {-0.01, 0, 0.01}}, {{0, 2, 1}, {0, 3, 2}}},
      false);
  for (const double side : {1.0, -1.0}) {
    SceneBody body;
    body.rest = placed(makeSphere(0.002, 1), {.position_m = Vec3(0.001, side * 0.0025, 0.002)});
    SweptPairs pairs(tool, body);
    std::vector<Vec3> to_m = body.rest.vertices_m;
    for (Vec3& v : to_m) v.y() -= side * 0.02;
    const TissuePath path{body.rest.vertices_m, to_m};
    pairs.gather(path, 0.001);
    std::vector<SweptPair> found;
    pairs.findNear(path, 0.001, found);
    ASSERT_FALSE(found.empty());
    const std::size_t near = found.size();
    pairs.findCrossings(path, kSeparation_m, found);
    ASSERT_GT(found.size(), near) << "it goes through";
    for (const SweptPair& pair : found) {
      EXPECT_TRUE(pair.kind != PairKind::vertex_face || side * pair.normal.y() > 0.999);
    }
    EXPECT_FALSE(pairs.overlap(to_m)) << "and is free again at the end";
  }
}

TEST(SurfaceOverlap, IsCrossingOrContainment) {
  const SceneTool tool = toolOf(makeBox(Vec3(0.02, 0.002, 0.02)));
  const auto overlaps = [&](double radius_m, double height_m) {
    SceneBody body;
    body.rest = placed(makeSphere(radius_m, 1), {.position_m = Vec3(0.001, height_m, 0.002)});
    return SweptPairs(tool, body).overlap(body.rest.vertices_m);
  };
  EXPECT_FALSE(overlaps(0.002, 0.0035));
  EXPECT_TRUE(overlaps(0.002, 0.002));
  EXPECT_TRUE(overlaps(0.0002, 0)) << "inside the tool";
  EXPECT_TRUE(overlaps(0.1, 0)) << "round the tool";
}

// Of two shells any may be inside: the first one is clear of the other surface.
TEST(SurfaceOverlap, LooksAtEveryShell) {
  TriangleMesh two = placed(makeSphere(0.0002, 1), {.position_m = Vec3(0.1, 0, 0)});
  const TriangleMesh inside = placed(makeSphere(0.0002, 1), {.position_m = Vec3(0.001, 0, 0.002)});
  const int first = static_cast<int>(two.vertices_m.size());
  two.vertices_m.insert(two.vertices_m.end(), inside.vertices_m.begin(), inside.vertices_m.end());
  for (const auto& [a, b, c] : inside.faces) two.faces.push_back({first + a, first + b, first + c});
  SceneBody box, pair;
  box.rest = makeBox(Vec3(0.02, 0.002, 0.02));
  pair.rest = two;
  EXPECT_TRUE(SweptPairs(toolOf(box.rest), pair).overlap(pair.rest.vertices_m));
  EXPECT_TRUE(SweptPairs(toolOf(two), box).overlap(box.rest.vertices_m));
}

}  // namespace
}  // namespace fissure::swept_pairs_test
