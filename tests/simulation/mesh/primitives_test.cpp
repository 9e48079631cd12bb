#include "mesh/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "defect_lines.h"
#include "mesh/check.h"

namespace fissure::primitives_test {

namespace {

/// Undirected edges, counted without the code under test.
std::size_t countEdges(const TriangleMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (const Face& face : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(int(face[k]), int(face[(k + 1) % 3])));
  return edges.size();
}

/// Faces whose normal does not point away from the origin; right for any star-shaped surface around it.
int countInwardFaces(const TriangleMesh& mesh) {
  int inward = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3 &p = mesh.vertices_m[a], &q = mesh.vertices_m[b], &r = mesh.vertices_m[c];
    if (!((q - p).cross(r - p).dot(p + q + r) > 0)) ++inward;
  }
  return inward;
}

TEST(Sphere, HasTheCountsOfASubdividedOctahedron) {
  struct Count {
    int subdivisions;
    std::size_t vertices, faces;
  };
  // 2 is the paper's sphere (contact/METHOD.md 1), 3 a finer one.
  for (const Count& count :
       {Count{0, 6, 8}, Count{1, 18, 32}, Count{2, 66, 128}, Count{3, 258, 512}, Count{4, 1026, 2048}}) {
    const TriangleMesh sphere = makeSphere(0.03, count.subdivisions);
    EXPECT_EQ(sphere.vertices_m.size(), count.vertices);
    EXPECT_EQ(sphere.faces.size(), count.faces);
    const auto euler = static_cast<long>(sphere.vertices_m.size() + sphere.faces.size()) -
                       static_cast<long>(countEdges(sphere));
    EXPECT_EQ(euler, 2);
    EXPECT_EQ(countInwardFaces(sphere), 0);
    EXPECT_EQ(findDefects(sphere), std::vector<std::string>{});
  }
}

TEST(Sphere, HasEveryVertexAtItsRadius) {
  for (const Vec3& vertex : makeSphere(0.03, 4).vertices_m) EXPECT_NEAR(vertex.norm(), 0.03, 1e-16);
}

TEST(Sphere, HalvesGreatCircleEdgesEvenly) {
  // Twice subdivided: the four edges between +x and +y are arcs of 22.5 degrees, so this vertex exists.
  const double angle = std::numbers::pi / 8;
  const Vec3 wanted(std::cos(angle), std::sin(angle), 0);
  double nearest = 1;
  for (const Vec3& vertex : makeSphere(1, 2).vertices_m)
    nearest = std::min(nearest, (vertex - wanted).norm());
  EXPECT_LT(nearest, 1e-15);
}

TEST(Sphere, WithoutSubdivisionIsAnOctahedronOfExactVolume) {
  EXPECT_DOUBLE_EQ(signedVolume_m3(makeSphere(0.5, 0)), 4.0 / 3.0 * 0.125);
}

TEST(Sphere, VolumeConvergesToTheBallsWithOrderTwo) {
  const double ball_m3 = 4.0 / 3.0 * std::numbers::pi * std::pow(0.03, 3);
  double previous_error = ball_m3 - signedVolume_m3(makeSphere(0.03, 3));
  for (int subdivisions = 4; subdivisions <= 7; ++subdivisions) {
    const double error = ball_m3 - signedVolume_m3(makeSphere(0.03, subdivisions));
    EXPECT_GT(error, 0);  // inscribed
    EXPECT_NEAR(std::log2(previous_error / error), 2.0, 0.02);
    previous_error = error;
  }
  EXPECT_LT(previous_error, 2e-4 * ball_m3);
}

TEST(Box, HasItsSizeVolumeAndOutwardFaces) {
  // The paper's spatula: 40 x 2 x 15 mm.
  const TriangleMesh box = makeBox({0.04, 0.002, 0.015});
  EXPECT_EQ(box.vertices_m.size(), 8u);
  EXPECT_EQ(box.faces.size(), 12u);
  EXPECT_EQ(countEdges(box), 18u);
  EXPECT_EQ(countInwardFaces(box), 0);
  EXPECT_EQ(findDefects(box), std::vector<std::string>{});
  for (const Vec3& corner : box.vertices_m) EXPECT_EQ(corner.cwiseAbs(), Vec3(0.02, 0.001, 0.0075));
  EXPECT_DOUBLE_EQ(signedVolume_m3(makeBox({2, 4, 8})), 64.0);
  EXPECT_NEAR(signedVolume_m3(box), 0.04 * 0.002 * 0.015, 1e-20);
}

// Today's box of twelve triangles, which scenes of record have.
TEST(Box, OfOneCellKeepsItsVerticesAndFaces) {
  const TriangleMesh box = makeBox({2, 4, 6}, {1, 1, 1});
  for (int corner = 0; corner < 8; ++corner)
    EXPECT_EQ(box.vertices_m[static_cast<std::size_t>(corner)],
              Vec3((corner & 1) ? 1 : -1, (corner & 2) ? 2 : -2, (corner & 4) ? 3 : -3));
  EXPECT_EQ(box.faces, (std::vector<Face>{{0, 4, 6},
                                          {0, 6, 2},
                                          {1, 3, 7},
                                          {1, 7, 5},
                                          {0, 1, 5},
                                          {0, 5, 4},
                                          {2, 6, 7},
                                          {2, 7, 3},
                                          {0, 2, 3},
                                          {0, 3, 1},
                                          {4, 5, 7},
                                          {4, 7, 6}}));
}

TEST(Box, OfCellsIsAClosedSurfaceOnTheSamePlanes) {
  for (const std::array<int, 3>& cells :
       {std::array<int, 3>{2, 2, 2}, {1, 1, 7}, {3, 4, 5}, {16, 1, 8}, {1, 2, 1}}) {
    const BoxShape shape{Vec3(0.04, 0.002, 0.015), cells};
    const TriangleMesh box = makeBox(shape.size_m, cells);
    EXPECT_EQ(static_cast<double>(box.faces.size()), shape.triangles());
    EXPECT_EQ(findDefects(box), std::vector<std::string>{});
    EXPECT_EQ(box.vertices_m.size() + box.faces.size() - countEdges(box), 2u);
    EXPECT_EQ(countInwardFaces(box), 0);
    EXPECT_NEAR(signedVolume_m3(box) / shape.size_m.prod(), 1, 1e-14);
    for (const Vec3& vertex : box.vertices_m) {
      const Vec3 outside = vertex.cwiseAbs() - shape.size_m / 2;
      EXPECT_EQ(outside.maxCoeff(), 0) << "on a side, not near it";
      const Vec3 mirrored = -vertex;
      EXPECT_EQ(std::count(box.vertices_m.begin(), box.vertices_m.end(), mirrored), 1);
    }
  }
}

TEST(Capsule, IsAClosedSurfaceOfEvenTriangles) {
  for (int subdivisions = 0; subdivisions <= 4; ++subdivisions) {
    const CapsuleShape shape{.radius_m = 0.01, .length_m = 0.07, .subdivisions = subdivisions};
    const TriangleMesh capsule =
        makeCapsule(shape.radius_m, shape.length_m, subdivisions, static_cast<int>(shape.rows()));
    EXPECT_EQ(findDefects(capsule), std::vector<std::string>{});
    EXPECT_EQ(static_cast<double>(capsule.faces.size()), shape.triangles());
    EXPECT_EQ(capsule.vertices_m.size() + capsule.faces.size() - countEdges(capsule), 2u);
    EXPECT_EQ(countInwardFaces(capsule), 0);
    for (const Vec3& v : capsule.vertices_m) {
      const double along_m = std::clamp(v.x(), -0.035, 0.035);
      EXPECT_NEAR((v - Vec3(along_m, 0, 0)).norm(), 0.01, 1e-15);
    }
  }
}

TEST(Capsule, VolumeConvergesToCylinderAndBall) {
  const double pi = std::numbers::pi, exact_m3 = pi * 1e-4 * 0.07 + 4.0 / 3.0 * pi * 1e-6;
  EXPECT_NEAR(signedVolume_m3(makeCapsule(0.01, 0.07, 6, 4)), exact_m3, 4e-4 * exact_m3);
}

// A mesh with a handedness would give the two jaws of a clamp different forces.
TEST(Capsule, IsItsOwnMirrorImage) {
  const TriangleMesh capsule = makeCapsule(0.01, 0.07, 2, 6);
  const auto key = [](const Vec3& p) {
    return std::array<long, 3>{std::lround(1e9 * p.x()), std::lround(1e9 * p.y()), std::lround(1e9 * p.z())};
  };
  const auto triangles = [&](const Vec3& signs) {
    std::set<std::set<std::array<long, 3>>> all;
    for (const Face& face : capsule.faces) {
      std::set<std::array<long, 3>> corners;
      for (const int v : face) corners.insert(key(capsule.vertices_m[v].cwiseProduct(signs)));
      all.insert(corners);
    }
    return all;
  };
  const auto own = triangles(Vec3(1, 1, 1));
  for (const Vec3& signs : {Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)}) EXPECT_EQ(triangles(signs), own);
}

}  // namespace
}  // namespace fissure::primitives_test
