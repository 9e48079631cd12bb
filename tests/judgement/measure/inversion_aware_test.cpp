// Depth that inversion hides: what the plain depth does not see of a tool in tissue that is inside out or
// folded over.
#include <gtest/gtest.h>

#include <algorithm>

#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"
#include "surface/winding.h"

namespace fissure::inversion_aware_test {

namespace {

const Vec3 kBlade(0.04, 0.002, 0.015);

TriangleMesh insideOut(TriangleMesh mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

Penetration measureIn(const TriangleMesh& body, const Pose& pose) {
  const Scene scene = test::makeScene({body}, {kBlade});
  return PenetrationMeter(scene, {}).measure(test::restState(scene, {pose}));
}

// A blade in the middle of a box of 0.2 m: its samples are 0.1 m deep, whichever way the faces look.
TEST(InversionAwareDepth, CountsTissueThatIsInsideOut) {
  const TriangleMesh box = makeBox({0.2, 0.2, 0.2});
  const Penetration sound = measureIn(box, test::at(0, 0, 0));
  EXPECT_NEAR(sound.depth_m, 0.1, 0.001);
  EXPECT_EQ(sound.inversion_aware_m, sound.depth_m);
  const Penetration inverted = measureIn(insideOut(box), test::at(0, 0, 0));
  EXPECT_EQ(inverted.depth_m, 0);
  EXPECT_NEAR(inverted.inversion_aware_m, sound.depth_m, 1e-12);
  EXPECT_EQ(measureIn(insideOut(box), test::at(0, 0.2, 0)).inversion_aware_m, 0) << "outside of it";
}

// Two boxes in one body, the small one wholly in the large one: between the small one's faces and the tool
// there is tissue, not the outside. The way out is that of the large one.
TEST(InversionAwareDepth, DoesNotTakeBuriedTrianglesForTheOutside) {
  const TriangleMesh folded = test::together(makeBox({0.2, 0.2, 0.2}), makeBox({0.06, 0.06, 0.06}));
  const Penetration found = measureIn(folded, test::at(0, 0, 0));
  EXPECT_NEAR(found.depth_m, 0.03, 0.001) << "to the small box";
  EXPECT_NEAR(found.inversion_aware_m, 0.1, 0.001) << "to the large one";
}

/// Over samples whose winding number is not 0, the distance to all triangles with the outside on one side.
double slowDepth_m(const TriangleMesh& body, const std::vector<Vec3>& samples_m, const Pose& pose) {
  TriangleMesh outer = body;
  outer.faces.clear();
  const SurfaceTree tree(body);
  std::vector<std::uint8_t> buried(body.faces.size());
  countInvertedTriangles(tree, buried);
  for (const Face& face : body.faces) {
    const auto corner = [&](int i) {
      return SurfaceTree::toTree(
          body.vertices_m[static_cast<std::size_t>(face[static_cast<std::size_t>(i)])]);
    };
    for (std::size_t i = 0; i < buried.size(); ++i) {
      const TreeTriangle& t = tree.triangles()[i];
      if (buried[i] == 0 && t.a == corner(0) && t.b == corner(1) && t.c == corner(2))
        outer.faces.push_back(face);
    }
  }
  double depth_m = 0;
  for (const Vec3& sample_m : samples_m) {
    const Vec3 point_m = pose.toScene(sample_m);
    if (std::abs(test::solidAngleWinding(body, point_m)) > 0.5)
      depth_m = std::max(depth_m, test::bruteDistance(outer, point_m));
  }
  return depth_m;
}

TEST(InversionAwareDepth, IsTheSlowOneOnCrumpledSpheresAndNeverBelowThePlain) {
  std::mt19937 random(7);
  int deeper = 0, buried_runs = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const TriangleMesh body = test::crumpledSphere(0.03, 2, 0.4 + 0.01 * seed, seed);
    const Pose pose = test::randomPose(random, 0.02);
    const Scene scene = test::makeScene({body}, {kBlade});
    const Penetration found = PenetrationMeter(scene, {0.004}).measure(test::restState(scene, {pose}));
    EXPECT_GE(found.inversion_aware_m, found.depth_m);
    deeper += found.inversion_aware_m > found.depth_m;
    std::vector<std::uint8_t> buried(body.faces.size());
    countInvertedTriangles(SurfaceTree(body), buried);
    buried_runs += std::count(buried.begin(), buried.end(), 1) > 0;
    const ToolSamples samples = makeToolSamples(scene, scene.tools[0], 0.004);
    EXPECT_NEAR(found.inversion_aware_m, std::max(found.depth_m, slowDepth_m(body, samples.points_m, pose)),
                1e-12)
        << seed;
  }
  EXPECT_GT(deeper, 5);
  EXPECT_GT(buried_runs, 5);
}

}  // namespace
}  // namespace fissure::inversion_aware_test
