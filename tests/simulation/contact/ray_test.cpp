#include "contact/ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/face_tree.h"
#include "mesh/primitives.h"

namespace fissure::ray_test {

namespace {

Vec3 randomPoint(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

/// The obvious way, written differently: plane intersection, then areas. No ties, no tree.
std::optional<SurfaceHit> slowFirstHit(const TriangleMesh& mesh, const Vec3& origin, const Vec3& direction,
                                       double limit) {
  std::optional<SurfaceHit> best;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Vec3& a = mesh.vertices_m[mesh.faces[i][0]];
    const Vec3& b = mesh.vertices_m[mesh.faces[i][1]];
    const Vec3& c = mesh.vertices_m[mesh.faces[i][2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const double cosine = normal.dot(direction);
    if (cosine == 0) continue;
    const double t = normal.dot(a - origin) / cosine;
    if (t < 0 || t > limit) continue;
    const Vec3 p = origin + t * direction;
    const double area = (b - a).cross(c - a).dot(normal);
    const double wa = (c - b).cross(p - b).dot(normal) / area;
    const double wb = (a - c).cross(p - c).dot(normal) / area;
    const double wc = 1 - wa - wb;
    if (wa < 0 || wb < 0 || wc < 0) continue;
    if (!best || t < best->at.distance_m) best = SurfaceHit{static_cast<int>(i), {t, {wa, wb, wc}, cosine}};
  }
  return best;
}

TEST(Ray, TellsDistanceWeightsAndSideOfATriangleInThePlaneZ1) {
  // Counter-clockwise seen from +z: the normal is +z. A ray upwards leaves, a ray downwards enters.
  const Vec3 a(0, 0, 1), b(2, 0, 1), c(0, 2, 1);
  const auto up = Ray(Vec3(0.5, 0.25, 0), Vec3::UnitZ(), 5).intersect(a, b, c);
  ASSERT_TRUE(up);
  EXPECT_DOUBLE_EQ(up->distance_m, 1);
  EXPECT_DOUBLE_EQ(up->cosine, 1);
  EXPECT_DOUBLE_EQ(up->weights[0], 1 - 0.25 - 0.125);
  EXPECT_DOUBLE_EQ(up->weights[1], 0.25);
  EXPECT_DOUBLE_EQ(up->weights[2], 0.125);
  const auto down = Ray(Vec3(0.5, 0.25, 3), -Vec3::UnitZ(), 5).intersect(a, b, c);
  ASSERT_TRUE(down);
  EXPECT_DOUBLE_EQ(down->distance_m, 2);
  EXPECT_DOUBLE_EQ(down->cosine, -1);
}

TEST(Ray, EndsAtItsLengthAndStartsAtItsOrigin) {
  const Vec3 a(0, 0, 1), b(2, 0, 1), c(0, 2, 1);
  EXPECT_TRUE(Ray(Vec3(0.5, 0.5, 0), Vec3::UnitZ(), 1.0).intersect(a, b, c));
  EXPECT_FALSE(Ray(Vec3(0.5, 0.5, 0), Vec3::UnitZ(), 0.999).intersect(a, b, c));
  EXPECT_FALSE(Ray(Vec3(0.5, 0.5, 2), Vec3::UnitZ(), 5).intersect(a, b, c)) << "behind the origin";
  EXPECT_TRUE(Ray(Vec3(0.5, 0.5, 1), Vec3::UnitZ(), 5).intersect(a, b, c)) << "at the origin";
}

TEST(Ray, GrazingRaysAndDegenerateTrianglesAreNoHit) {
  const Vec3 a(0, 0, 1), b(2, 0, 1), c(0, 2, 1);
  EXPECT_FALSE(Ray(Vec3(-1, 0.5, 1), Vec3::UnitX(), 5).intersect(a, b, c)) << "in the plane";
  const Vec3 almost = Vec3(1, 0, 1e-11).normalized();
  EXPECT_FALSE(Ray(Vec3(-1, 0.5, 1), almost, 5).intersect(a, b, c)) << "within rounding of the plane";
  EXPECT_FALSE(Ray(Vec3(0.5, 0, 0), Vec3::UnitZ(), 5).intersect(a, b, Vec3(1, 0, 1))) << "no area";
}

TEST(Ray, IsWatertightThroughEdgesAndVerticesOfAClosedSurface) {
  // From the middle of a sphere towards every vertex and to points on every edge: the surface is never
  // missed.
  const TriangleMesh sphere = makeSphere(0.03, 3);
  const FaceTree tree(sphere.vertices_m, sphere.faces);
  long long tests = 0;
  const Vec3 middle(1e-3, 2e-3, -3e-3);
  std::vector<Vec3> targets = sphere.vertices_m;
  for (const Face& face : sphere.faces) {
    for (int j = 0; j < 3; ++j) {
      const Vec3& a = sphere.vertices_m[face[j]];
      const Vec3& b = sphere.vertices_m[face[(j + 1) % 3]];
      for (const double s : {0.5, 0.25, 1.0 / 3.0}) targets.push_back(a + s * (b - a));
    }
  }
  for (const Vec3& target : targets) {
    const auto hit = tree.firstHit(Ray(middle, (target - middle).normalized(), 1), sphere.vertices_m, tests);
    ASSERT_TRUE(hit) << target.transpose();
    EXPECT_NEAR(hit->at.distance_m, (target - middle).norm(), 1e-12);
    EXPECT_GT(hit->at.cosine, 0) << "from inside every first hit leaves";
  }
}

TEST(FaceTree, ARayThroughASharedVertexTakesTheLowestFace) {
  // Four triangles of the plane z = 0 meet in the origin; all are hit at exactly the same distance.
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (int first = 0; first < 4; ++first) {
    std::vector<Face> faces;
    for (int i = 0; i < 4; ++i) faces.push_back({0, 1 + (first + i) % 4, 1 + (first + i + 1) % 4});
    const FaceTree tree(positions, faces);
    long long tests = 0;
    const auto hit = tree.firstHit(Ray(Vec3(0, 0, -1), Vec3::UnitZ(), 5), positions, tests);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->face, 0);
  }
}

TEST(FaceTree, AgreesWithASlowOneOnRandomRaysThroughADeformedBody) {
  std::mt19937_64 random(1);
  TriangleMesh body = makeSphere(0.03, 3);
  const FaceTree built(body.vertices_m, body.faces);
  FaceTree tree = built;
  long long tests = 0;
  int hits = 0;
  for (int round = 0; round < 20; ++round) {
    for (Vec3& v : body.vertices_m) v += randomPoint(random, 0.002);
    tree.refit(body.vertices_m);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 origin = randomPoint(random, 0.04);
      const Vec3 direction = randomPoint(random, 1).normalized();
      const double limit = 0.06;
      const auto expected = slowFirstHit(body, origin, direction, limit);
      const auto hit = tree.firstHit(Ray(origin, direction, limit), body.vertices_m, tests);
      ASSERT_EQ(hit.has_value(), expected.has_value()) << "round " << round << ", ray " << i;
      if (!hit) continue;
      ++hits;
      ASSERT_EQ(hit->face, expected->face);
      ASSERT_NEAR(hit->at.distance_m, expected->at.distance_m, 1e-12);
      ASSERT_NEAR(hit->at.cosine, expected->at.cosine, 1e-9);
      for (int j = 0; j < 3; ++j) ASSERT_NEAR(hit->at.weights[j], expected->at.weights[j], 1e-7);
    }
  }
  EXPECT_GT(hits, 10000);
  EXPECT_LT(tests, 20LL * 2000 * 512 / 10) << "the tree must spare most of the 512 triangles";
}

TEST(FaceTree, AxisParallelRaysMeetBoxFacesThroughTheirDiagonals) {
  // The two triangles of each side of a box share a diagonal, and every ray below runs through one.
  const TriangleMesh box = makeBox({2, 2, 2});
  const FaceTree tree(box.vertices_m, box.faces);
  long long tests = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const auto hit = tree.firstHit(Ray(Vec3::Zero(), sign * Vec3::Unit(axis), 5), box.vertices_m, tests);
      ASSERT_TRUE(hit);
      EXPECT_DOUBLE_EQ(hit->at.distance_m, 1);
    }
  }
}

}  // namespace
}  // namespace fissure::ray_test
