#include "measure/node_spacing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/centroid_nodes.h"
#include "contact/grid_nodes.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::node_spacing_test {

namespace {

Scene plateScene(int subdivisions, int nodes) {
  const Vec3 plate(0.07, 0.001, 0.07);
  Scene scene = test::makeScene({makeSphere(0.03, subdivisions)}, {plate});
  scene.tools[0].name = "plate";
  if (nodes > 0) scene.tools[0].nodes = makeGridNodes(plate, {nodes, nodes});
  return scene;
}

// A square grid's own step, from above by what the samples next to the middle of a cell miss.
TEST(NodeSpacing, OfASquareGridIsItsStep) {
  for (const int nodes : {8, 15, 36}) {
    const auto spacing = widestNodeSpacing(plateScene(2, nodes));
    ASSERT_TRUE(spacing);
    const double step_m = 0.07 / (nodes - 1);
    EXPECT_LE(spacing->spacing_m, 1.03 * step_m)
        << "a blade 1 mm thick, its rim half of that beside the nodes";
    EXPECT_GE(spacing->spacing_m, 0.85 * step_m);
    EXPECT_EQ(spacing->tool, "plate");
  }
}

TEST(NodeSpacing, IsTakenAgainstTheFinestBody) {
  Scene scene = plateScene(2, 8);
  scene.bodies.push_back(test::makeScene({makeSphere(0.03, 3)}, {}).bodies[0]);
  scene.bodies[1].name = "fine";
  const auto spacing = widestNodeSpacing(scene);
  ASSERT_TRUE(spacing);
  EXPECT_EQ(spacing->body, "fine");
  EXPECT_LT(spacing->edge_m, 0.6 * widestNodeSpacing(plateScene(2, 8))->edge_m);
  EXPECT_GT(spacing->ratio(), kWideNodes);
  EXPECT_LT(widestNodeSpacing(plateScene(2, 36))->ratio(), kWideNodes);
}

// A CAD program's spatula: two long triangles a face, and a node in the middle of each.
TEST(NodeSpacing, OfOneNodeATriangleIsWideOnLargeTriangles) {
  Scene scene = plateScene(2, 0);
  scene.tools[0].box_size_m.reset();
  scene.tools[0].surface = makeBox({0.09, 0.002, 0.015});
  scene.tools[0].nodes = makeCentroidNodes(scene.tools[0].surface, {.rim_nodes = false});
  const auto spacing = widestNodeSpacing(scene);
  ASSERT_TRUE(spacing);
  EXPECT_GT(spacing->spacing_m, 0.03);
  EXPECT_GT(spacing->ratio(), 2);
}

TEST(NodeSpacing, IsNoneWithoutNodes) {
  EXPECT_FALSE(widestNodeSpacing(plateScene(2, 0)));
}

TEST(NodeSpacing, SaysWhatItMeans) {
  EXPECT_EQ(wideNodesText(0.0051, 0.724),
            "nodes are up to 5.1 mm apart, 0.72 of a mean tissue edge: above 0.5 tissue gets in between");
}

}  // namespace
}  // namespace fissure::node_spacing_test
