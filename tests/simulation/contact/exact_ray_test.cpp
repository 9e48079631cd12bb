// The ray caster against exact arithmetic: coordinates are whole numbers, so that ties are ties.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/face_tree.h"
#include "mesh/primitives.h"

namespace fissure::exact_ray_test {

namespace {

__extension__ using Int128 = __int128;
using Whole = Eigen::Matrix<std::int64_t, 3, 1>;

#ifdef __SANITIZE_ADDRESS__
constexpr int kShare = 5;
#else
constexpr int kShare = 1;
#endif

Whole wholeIn(std::mt19937_64& random, int half) {
  std::uniform_int_distribution<int> uniform(-half, half);
  const int x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

/// Vertices rounded to whole numbers, up to a few thousand.
struct WholeMesh {
  WholeMesh(const TriangleMesh& mesh, double scale) : faces(mesh.faces) {
    for (const Vec3& v : mesh.vertices_m) {
      rounded_m.emplace_back((scale * v).array().round().matrix());
      vertices.push_back(rounded_m.back().cast<std::int64_t>());
    }
  }
  const Whole& corner(const Face& face, int i) const { return vertices[static_cast<std::size_t>(face[i])]; }
  std::vector<Vec3> rounded_m;
  std::vector<Whole> vertices;
  std::vector<Face> faces;
};

/// A fraction with a positive denominator.
struct ExactHit {
  int face = -1;
  Int128 over = 0, under = 1;
  bool leaves = false;
};

bool nearer(const ExactHit& one, const ExactHit& other) {
  return other.face < 0 || one.over * other.under < other.over * one.under;
}

/// The first triangle, of equally near ones the lowest: `direction` of any length, distances in its lengths.
/// The ray meets a triangle, border included, when the volumes that it spans with the edges have one sign.
ExactHit exactFirstHit(const WholeMesh& mesh, const Whole& origin, const Whole& direction) {
  ExactHit best;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Whole a = mesh.corner(mesh.faces[i], 0) - origin, b = mesh.corner(mesh.faces[i], 1) - origin;
    const Whole c = mesh.corner(mesh.faces[i], 2) - origin;
    const auto volume = [&](const Whole& normal) {
      Int128 sum = 0;
      for (int k = 0; k < 3; ++k) sum += static_cast<Int128>(normal[k]) * direction[k];
      return sum;
    };
    const Int128 ab = volume(a.cross(b)), bc = volume(b.cross(c)), ca = volume(c.cross(a));
    if ((ab < 0 || bc < 0 || ca < 0) && (ab > 0 || bc > 0 || ca > 0)) continue;
    const Whole normal = (b - a).cross(c - a);
    const Int128 slope = volume(normal);
    if (slope == 0) continue;
    const Int128 height = normal.dot(a);
    const ExactHit hit{static_cast<int>(i), slope > 0 ? height : -height, slope > 0 ? slope : -slope,
                       slope > 0};
    if (hit.over >= 0 && nearer(hit, best)) best = hit;
  }
  return best;
}

/// Many triangles between few points: edges, vertices and planes meet everywhere.
TriangleMesh soup(int triangles, int half) {
  std::mt19937_64 random(5);
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    for (int k = 0; k < 3; ++k) mesh.vertices_m.push_back(wholeIn(random, half).cast<double>());
    mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

// With an axis-parallel ray every operation of the caster is exact but the last division, so that it must
// give the very triangle and the very number.
TEST(ExactRay, AxisParallelRaysGiveTheLowestOfTheNearestTriangles) {
  std::mt19937_64 random(11);
  struct Subject {
    WholeMesh mesh;
    int half, rays;
  };
  for (const Subject& subject :
       {Subject{WholeMesh(soup(60, 4), 1), 5, 150'000}, Subject{WholeMesh(soup(200, 6), 1), 7, 40'000},
        Subject{WholeMesh(makeBox({8, 4, 6}), 1), 6, 150'000},
        Subject{WholeMesh(makeSphere(8, 2), 1), 9, 60'000},
        Subject{WholeMesh(makeSphere(1, 3), 1000), 40, 20'000}}) {
    const FaceTree tree(subject.mesh.rounded_m, subject.mesh.faces);
    long long tests = 0;
    int hits = 0;
    for (int i = 0; i < subject.rays / kShare; ++i) {
      const Whole origin = wholeIn(random, subject.half);
      const Whole direction = (i % 2 == 0 ? 1 : -1) * Whole::Unit(i / 2 % 3);
      const ExactHit expected = exactFirstHit(subject.mesh, origin, direction);
      const auto hit = tree.firstHit(Ray(origin.cast<double>(), direction.cast<double>(), 5000),
                                     subject.mesh.rounded_m, tests);
      ASSERT_EQ(hit ? hit->face : -1, expected.face)
          << "from " << origin.transpose() << " along " << direction.transpose();
      if (!hit) continue;
      ++hits;
      ASSERT_EQ(hit->at.distance_m, static_cast<double>(expected.over) / static_cast<double>(expected.under));
      ASSERT_EQ(hit->at.cosine > 0, expected.leaves);
    }
    EXPECT_GT(hits, subject.rays / kShare / 5);
  }
}

// The length of a ray is inclusive, exactly.
TEST(ExactRay, ARayReachesJustWhatItsLengthReaches) {
  const WholeMesh mesh(soup(100, 5), 1);
  const FaceTree tree(mesh.rounded_m, mesh.faces);
  std::mt19937_64 random(12);
  long long tests = 0;
  int reached = 0, short_of_it = 0;
  for (int i = 0; i < 40'000 / kShare; ++i) {
    const Whole origin = wholeIn(random, 6), direction = Whole::Unit(i % 3);
    const int length = static_cast<int>(random() % 8);
    const ExactHit nearest = exactFirstHit(mesh, origin, direction);
    const bool expected = nearest.face >= 0 && nearest.over <= length * nearest.under;
    const auto hit =
        tree.firstHit(Ray(origin.cast<double>(), direction.cast<double>(), length), mesh.rounded_m, tests);
    ASSERT_EQ(hit.has_value(), expected);
    reached += expected && nearest.over == length * nearest.under;
    short_of_it += nearest.face >= 0 && !expected;
  }
  EXPECT_GT(reached, 1'000 / kShare);
  EXPECT_GT(short_of_it, 3'000 / kShare);
}

// Skew rays out of a closed surface, at vertices and edges of it: the direction's doubles are taken as the
// whole numbers that they are (times 2^53), so that the exact first meeting is known though no such ray goes
// exactly through an edge.
TEST(ExactRay, SkewRaysAtEdgesOfAClosedSurfaceLeaveWhereTheyExactlyDo) {
  const WholeMesh mesh(makeSphere(1, 2), 1000);
  const FaceTree tree(mesh.rounded_m, mesh.faces);
  std::mt19937_64 random(13);
  long long tests = 0;
  for (int i = 0; i < 60'000 / kShare; ++i) {
    const Whole origin = wholeIn(random, 400);
    const Face& face = mesh.faces[random() % mesh.faces.size()];
    const int edge = static_cast<int>(random() % 3);
    const Vec3 a = mesh.corner(face, edge).cast<double>();
    const Vec3 b = mesh.corner(face, (edge + 1) % 3).cast<double>();
    const double share = i % 3 == 0 ? 0 : static_cast<double>(random() % 1024) / 1024;
    Vec3 direction = (a + share * (b - a) - origin.cast<double>()).normalized();
    const Whole scaled = (0x1p53 * direction).array().round().matrix().cast<std::int64_t>();
    direction = 0x1p-53 * scaled.cast<double>();
    const ExactHit expected = exactFirstHit(mesh, origin, scaled);
    ASSERT_GE(expected.face, 0) << "the surface is closed";
    const auto hit = tree.firstHit(Ray(origin.cast<double>(), direction, 5000), mesh.rounded_m, tests);
    ASSERT_TRUE(hit) << "leak from " << origin.transpose();
    const long double distance =
        0x1p53L * static_cast<long double>(expected.over) / static_cast<long double>(expected.under);
    ASSERT_NEAR(hit->at.distance_m, static_cast<double>(distance), 1e-10);
    ASSERT_GT(hit->at.cosine, 0);
  }
}

// Rays in the plane of a side: no hit on it, but on the edge of the side that stands across.
TEST(ExactRay, ARayInThePlaneOfASideMeetsOnlyTheSideAcross) {
  const WholeMesh mesh(makeBox({4, 4, 4}), 1);
  const FaceTree tree(mesh.rounded_m, mesh.faces);
  long long tests = 0;
  for (int along = 0; along < 3; ++along) {
    for (int beside = -2; beside <= 2; ++beside) {
      for (const double sign : {1.0, -1.0}) {
        Vec3 origin = -6 * sign * Vec3::Unit(along);
        origin[(along + 1) % 3] = 2;
        origin[(along + 2) % 3] = beside;
        const auto hit = tree.firstHit(Ray(origin, sign * Vec3::Unit(along), 20), mesh.rounded_m, tests);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->at.distance_m, 4);
        EXPECT_EQ(hit->at.cosine, -1);
        origin[(along + 1) % 3] = 2.0000001;
        EXPECT_FALSE(tree.firstHit(Ray(origin, sign * Vec3::Unit(along), 20), mesh.rounded_m, tests));
      }
    }
  }
}

}  // namespace
}  // namespace fissure::exact_ray_test
