#include "measure/tool_samples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/error.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::tool_samples_test {

namespace {

const Vec3 kSpatula(0.04, 0.002, 0.015);

Scene spatulaOnSphere() {
  return test::makeScene({makeSphere(0.03, 2)}, {kSpatula});
}

double nearest(const std::vector<Vec3>& points, const Vec3& to) {
  double best = 1e9;
  for (const Vec3& point : points) best = std::min(best, (point - to).norm());
  return best;
}

TEST(ToolSamples, AboutThreeThousandOnThePapersSpatula) {
  const Scene scene = spatulaOnSphere();
  const ToolSamples samples = makeToolSamples(scene, scene.tools[0], std::nullopt);
  EXPECT_GT(samples.points_m.size(), 2'700u);
  EXPECT_LT(samples.points_m.size(), 3'300u);
  EXPECT_LT(samples.coverage_m, 0.00055);
}

TEST(ToolSamples, LieOnTheSurfaceAndCoverAllSixFaces) {
  const Scene scene = spatulaOnSphere();
  for (const double spacing : {0.004, 0.001, 0.0005}) {
    const ToolSamples samples = makeToolSamples(scene, scene.tools[0], spacing);
    std::array<int, 6> on_face{};
    for (const Vec3& point : samples.points_m) {
      const Vec3 beyond = point.cwiseAbs() - kSpatula / 2;
      Eigen::Index axis = 0;
      EXPECT_NEAR(beyond.maxCoeff(&axis), 0, 1e-15);
      ++on_face[static_cast<std::size_t>(2 * axis + (point[axis] > 0))];
    }
    for (const int count : on_face) EXPECT_GE(count, 9);
    std::mt19937 random(41);
    for (int i = 0; i < 1'000; ++i) {
      Vec3 point = test::randomIn(random, 0.5).cwiseProduct(kSpatula);
      point[i % 3] = (i % 2 == 0 ? 0.5 : -0.5) * kSpatula[i % 3];
      EXPECT_LE(nearest(samples.points_m, point), samples.coverage_m + 1e-15);
    }
    EXPECT_LE(samples.coverage_m, spacing * std::sqrt(0.5) + 1e-15);
    for (const double x :
         {-0.5, 0.5}) {  // corners, where a tool is deepest: nearer than a seventh of the spacing
      EXPECT_LT(nearest(samples.points_m, Vec3(x, 0.5, -0.5).cwiseProduct(kSpatula)), spacing / 7);
    }
  }
}

// Fukuhara's nodes: a grid on both large faces, whether at the cells' centres or from edge to edge.
TEST(ToolSamples, NeverCoincideWithNodes) {
  const Scene scene = spatulaOnSphere();
  for (const std::optional<double> spacing :
       {std::optional<double>(), std::optional(0.005), std::optional(0.00125)}) {
    const ToolSamples samples = makeToolSamples(scene, scene.tools[0], spacing);
    for (const int nodes : {1, 2, 3, 4, 5, 8, 16, 32}) {
      for (const bool centred : {true, false}) {
        if (!centred && nodes == 1) continue;
        for (int k = 0; k < 2 * nodes * nodes; ++k) {
          const auto share = [&](int i) {
            return centred ? (i + 0.5) / nodes - 0.5 : i / (nodes - 1.0) - 0.5;
          };
          const Vec3 node =
              Vec3(share(k / 2 % nodes), k % 2 - 0.5, share(k / 2 / nodes)).cwiseProduct(kSpatula);
          // 2 um: above 1/400 of the default spacing.
          EXPECT_GT(nearest(samples.points_m, node), 2e-6) << nodes << " " << centred;
        }
      }
    }
  }
}

TEST(ToolSamples, NeverCoincideWithCentroidsAndVerticesOfATriangleTool) {
  Scene scene = spatulaOnSphere();
  scene.tools[0].box_size_m.reset();
  scene.tools[0].surface = makeSphere(0.01, 1);
  for (const std::optional<double> spacing :
       {std::optional<double>(), std::optional(0.02), std::optional(0.001)}) {
    const ToolSamples samples = makeToolSamples(scene, scene.tools[0], spacing);
    const TriangleMesh& mesh = scene.tools[0].surface;
    for (const Face& face : mesh.faces) {
      Vec3 centroid = Vec3::Zero();
      for (const int corner : face) centroid += mesh.vertices_m[static_cast<std::size_t>(corner)] / 3;
      EXPECT_GT(nearest(samples.points_m, centroid), 5e-6);
    }
    for (const Vec3& vertex : mesh.vertices_m) {
      EXPECT_GT(nearest(samples.points_m, vertex), 5e-6);
      EXPECT_LE(nearest(samples.points_m, vertex), samples.coverage_m);
    }
    for (const Vec3& point : samples.points_m) EXPECT_LT(test::bruteDistance(mesh, point), 1e-15);
  }
}

TEST(ToolSamples, AreFineAgainstTissueEdgesToo) {
  const Scene coarse = test::makeScene({makeSphere(0.03, 2)}, {kSpatula});
  const Scene fine = test::makeScene({makeSphere(0.03, 2), makeSphere(0.01, 4)}, {kSpatula});
  EXPECT_LT(makeToolSamples(fine, fine.tools[0], std::nullopt).coverage_m,
            0.6 * makeToolSamples(coarse, coarse.tools[0], std::nullopt).coverage_m);
}

TEST(ToolSamples, KeepTheLimitForHugeAndForExtremelyThinTools) {
  for (const Vec3& size :
       {Vec3(1.0, 1.0, 0.001), Vec3(0.04, 0.00002, 0.015), Vec3(1e-9, 1.0, 1.0), Vec3(10, 10, 10)}) {
    const Scene scene = test::makeScene({makeSphere(0.03, 4)}, {size});
    const std::size_t count = makeToolSamples(scene, scene.tools[0], std::nullopt).points_m.size();
    EXPECT_LE(count, 20'000u);
    EXPECT_GT(count, 15'000u);
  }
}

/// A flat bar of 90 x 1 x 12 mm with long, thin triangles, as CAD programs leave them: its large faces are
/// strips of 0.3 mm along it.
TriangleMesh stripedBar() {
  TriangleMesh bar;
  const int strips = 40;
  for (int i = 0; i <= strips; ++i)
    for (const double y : {-0.0005, 0.0005})
      for (const double x : {-0.045, 0.045}) bar.vertices_m.emplace_back(x, y, 0.0003 * i - 0.006);
  const auto quad = [&](int a, int b, int c, int d) {
    bar.faces.push_back({a, b, c});
    bar.faces.push_back({a, c, d});
  };
  for (int i = 0; i < strips; ++i) {
    const int k = 4 * i;
    quad(k, k + 1, k + 5, k + 4);      // below
    quad(k + 2, k + 6, k + 7, k + 3);  // above
    quad(k, k + 4, k + 6, k + 2);      // the ends
    quad(k + 1, k + 3, k + 7, k + 5);
  }
  quad(0, 2, 3, 1);
  quad(4 * strips, 4 * strips + 1, 4 * strips + 3, 4 * strips + 2);
  return bar;
}

// Placed by the triangles' longest edges, 20,000 samples were 2.8 mm apart on such a tool.
TEST(ToolSamples, ArePlacedByAreaHoweverThinTheTriangles) {
  Scene scene = test::makeScene({makeSphere(0.03, 2)}, {{0.09, 0.001, 0.012}});
  const ToolSamples box = makeToolSamples(scene, scene.tools[0], std::nullopt);
  scene.tools[0].box_size_m.reset();
  scene.tools[0].surface = stripedBar();
  const ToolSamples striped = makeToolSamples(scene, scene.tools[0], std::nullopt);
  EXPECT_LE(striped.points_m.size(), 20'000u);
  EXPECT_LT(striped.coverage_m, 0.0009);
  EXPECT_LT(striped.coverage_m, 3 * box.coverage_m);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 300; ++i) {
    const Face& face =
        scene.tools[0].surface.faces[static_cast<std::size_t>(i) % scene.tools[0].surface.faces.size()];
    const auto corner = [&](std::size_t k) {
      return scene.tools[0].surface.vertices_m[static_cast<std::size_t>(face[k])];
    };
    double s = share(random), t = share(random);
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    const Vec3 point = corner(0) + s * (corner(1) - corner(0)) + t * (corner(2) - corner(0));
    EXPECT_LE(nearest(striped.points_m, point), striped.coverage_m + 1e-15);
  }
}

TEST(ToolSamples, AnAbsurdSpacingOnTrianglesIsRefusedAtOnce) {
  Scene scene = spatulaOnSphere();
  scene.tools[0].box_size_m.reset();
  for (const double spacing : {1e-7, 1e-300})
    EXPECT_THROW(makeToolSamples(scene, scene.tools[0], spacing), InputError);
}

TEST(ToolSamples, AStatedSpacingIsKeptBeyondTheDefaultLimitAndRefusedWhereAbsurd) {
  const Scene scene = spatulaOnSphere();
  EXPECT_GT(makeToolSamples(scene, scene.tools[0], 0.0002).points_m.size(), 30'000u);
  EXPECT_THROW(makeToolSamples(scene, scene.tools[0], 1e-9), InputError);
  EXPECT_THROW(makeToolSamples(scene, scene.tools[0], 1e-300), InputError);
}

}  // namespace
}  // namespace fissure::tool_samples_test
