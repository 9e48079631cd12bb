#include "mesh/tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>

#include "mesh/ball_tetrahedra.h"
#include "mesh/check.h"
#include "mesh/hexahedron.h"
#include "mesh/lobes.h"
#include "mesh/primitives.h"
#include "mesh/tetrahedra_check.h"
#include "mesh/tetrahedron.h"

namespace fissure::tetrahedra_test {

namespace {

TriangleMesh surfaceOf(const SphereShape& s) {
  return makeSphere(s.radius_m, s.subdivisions);
}
TriangleMesh surfaceOf(const BoxShape& s) {
  return makeBox(s.size_m, s.cells);
}
TriangleMesh surfaceOf(const CapsuleShape& s) {
  return makeCapsule(s.radius_m, s.length_m, s.subdivisions, static_cast<int>(s.rows()));
}
TriangleMesh surfaceOf(const LobesShape& s) {
  return makeLobes(s);
}
TriangleMesh surfaceOf(const TrianglesShape&) {
  return {};
}
TriangleMesh surfaceOf(const FileShape&) {
  return {};
}
TriangleMesh surfaceOf(const SurfaceShape& shape) {
  return std::visit([](const auto& one) { return surfaceOf(one); }, shape);
}

struct Case {
  std::string name;
  SurfaceShape shape;
  std::size_t tetrahedra;
  double worst, mean;  ///< radius ratio, at least; measured, rounded down to two digits
};

const std::vector<Case>& cases() {
  static const Vec3 cube_m(0.04, 0.04, 0.04);
  static const std::vector<Case> all = {
      {"octahedron", SphereShape{0.03, 0}, 8, 0.73, 0.73},
      {"sphere 1", SphereShape{0.03, 1}, 64, 0.61, 0.75},
      {"sphere 2", SphereShape{0.03, 2}, 512, 0.59, 0.76},
      {"sphere 3", SphereShape{0.03, 3}, 4096, 0.59, 0.76},
      {"sphere 4", SphereShape{0.0123, 4}, 32768, 0.59, 0.76},
      {"box", BoxShape{cube_m}, 6, 0.71, 0.71},
      {"spatula", BoxShape{}, 6, 0.12, 0.12},
      {"box of cells", BoxShape{cube_m, {4, 4, 4}}, 384, 0.71, 0.71},
      {"odd box of cells", BoxShape{cube_m, {3, 5, 4}}, 360, 0.65, 0.65},
      {"row of cells", BoxShape{Vec3(0.01, 0.01, 0.05), {1, 1, 5}}, 30, 0.71, 0.71},
      {"capsule 0", CapsuleShape{0.008, 0.06, 0}, 56, 0.59, 0.63},
      {"capsule 1", CapsuleShape{0.008, 0.06, 1}, 544, 0.56, 0.72},
      {"capsule 2", CapsuleShape{0.008, 0.06, 2}, 4352, 0.59, 0.72},
      {"capsule 3", CapsuleShape{0.008, 0.06, 3}, 33280, 0.54, 0.71},
      {"short capsule", CapsuleShape{0.008, 0.001, 3}, 5632, 0.48, 0.71},
      {"lobes", LobesShape{}, 8232, 0.31, 0.81},
      {"coarse lobes", LobesShape{.slit_width_m = 0.003, .edge_m = 0.01}, 1920, 0.46, 0.77},
      {"flat lobes",  // the surface alone is as bad: flat corners of the flat side
       LobesShape{.size_m = {0.1, 0.02, 0.05}, .slit_depth_m = 0.019, .slit_width_m = 0.02, .edge_m = 0.004},
       13104, 0.05, 0.66},
      {"lobes of few cells",
       LobesShape{.size_m = {0.05, 0.06, 0.09}, .slit_depth_m = 0.01, .slit_width_m = 1e-5, .edge_m = 0.2},
       48, 0.14, 0.47}};
  return all;
}

/// Turned so that the least vertex comes first.
Face turned(Face face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

std::set<Face> turned(const std::vector<Face>& faces) {
  std::set<Face> all;
  for (const Face& face : faces) all.insert(turned(face));
  return all;
}

/// The outward sides that one tetrahedron alone has, found without the code under test.
std::set<Face> slowBoundary(const TetrahedralMesh& mesh) {
  std::set<Face> left;
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    for (const Face& side : {Face{a, c, b}, Face{a, b, d}, Face{b, c, d}, Face{a, d, c}}) {
      const bool met = left.erase(turned(Face{side[0], side[2], side[1]})) > 0;
      EXPECT_TRUE(met || left.insert(turned(side)).second) << "two tetrahedra on one side of a triangle";
    }
  }
  return left;
}

bool sameBits(const std::vector<Vec3>& a, const std::vector<Vec3>& b, std::size_t count) {
  return std::memcmp(a.data(), b.data(), count * sizeof(Vec3)) == 0;
}

TEST(Tetrahedra, HaveTheVerticesOfTheirSurfaceFirstBitForBit) {
  for (const Case& c : cases()) {
    const TetrahedralMesh volume = *makeTetrahedra(c.shape);
    const TriangleMesh surface = surfaceOf(c.shape);
    ASSERT_GE(volume.vertices_m.size(), surface.vertices_m.size()) << c.name;
    EXPECT_TRUE(sameBits(volume.vertices_m, surface.vertices_m, surface.vertices_m.size())) << c.name;
  }
}

TEST(Tetrahedra, HaveTheSurfaceAsTheirBoundary) {
  for (const Case& c : cases()) {
    const TetrahedralMesh volume = *makeTetrahedra(c.shape);
    const std::set<Face> wanted = turned(surfaceOf(c.shape).faces);
    EXPECT_EQ(slowBoundary(volume), wanted) << c.name;
    const std::vector<Face> boundary = boundaryFaces(volume);
    EXPECT_EQ(boundary.size(), wanted.size()) << c.name;
    EXPECT_EQ(turned(boundary), wanted) << c.name;
  }
}

TEST(Tetrahedra, FillTheirSurfaceWithPositiveVolumes) {
  for (const Case& c : cases()) {
    const TetrahedralMesh volume = *makeTetrahedra(c.shape);
    EXPECT_EQ(volume.tetrahedra.size(), c.tetrahedra) << c.name;
    EXPECT_EQ(tetrahedraOf(c.shape), static_cast<double>(c.tetrahedra)) << c.name;
    double least_m3 = INFINITY;
    for (const Tetrahedron& one : volume.tetrahedra)
      least_m3 = std::min(least_m3, signedVolume(cornersOf(volume, one)));
    EXPECT_GT(least_m3, 0) << c.name;
    const double wanted_m3 = signedVolume_m3(surfaceOf(c.shape));
    EXPECT_NEAR(qualityOf(volume).volume_m3 / wanted_m3, 1, 1e-12) << c.name;
  }
}

TEST(Tetrahedra, AreWellShaped) {
  for (const Case& c : cases()) {
    const TetrahedralMesh volume = *makeTetrahedra(c.shape);
    const TetrahedraQuality quality = qualityOf(volume);
    EXPECT_GT(quality.worst, c.worst) << c.name;
    EXPECT_LT(quality.worst, c.worst + 0.011) << c.name << ": a better bound can be stated";
    EXPECT_GT(quality.mean, c.mean) << c.name;
    EXPECT_TRUE(inspectTetrahedra(volume, surfaceOf(c.shape)).empty()) << c.name;
  }
}

TEST(Tetrahedra, AreTheSameToTheLastBitEachTimeTheyAreMade) {
  std::vector<TetrahedralMesh> first;
  for (const Case& c : cases()) first.push_back(*makeTetrahedra(c.shape));
  for (std::size_t i = 0; i < first.size(); ++i) {
    const TetrahedralMesh again = *makeTetrahedra(cases()[i].shape);
    EXPECT_EQ(again.tetrahedra, first[i].tetrahedra) << cases()[i].name;
    ASSERT_EQ(again.vertices_m.size(), first[i].vertices_m.size()) << cases()[i].name;
    EXPECT_TRUE(sameBits(again.vertices_m, first[i].vertices_m, again.vertices_m.size())) << cases()[i].name;
  }
}

// 262,144 tetrahedra: about 15 ms to make and 150 ms to inspect.
TEST(Tetrahedra, OfAFineSphereAreAsGoodAsThoseOfACoarseOne) {
  const SphereShape shape{0.03, 5};
  const TetrahedralMesh volume = *makeTetrahedra(shape);
  EXPECT_EQ(volume.tetrahedra.size(), 262144u);
  EXPECT_TRUE(inspectTetrahedra(volume, surfaceOf(shape)).empty());
  EXPECT_GT(qualityOf(volume).worst, 0.59);
}

TEST(Tetrahedra, AreMissingWhereOnlyASurfaceIsGiven) {
  for (const SurfaceShape& shape : {SurfaceShape(TrianglesShape{}), SurfaceShape(FileShape{})}) {
    EXPECT_FALSE(tetrahedraOf(shape));
    EXPECT_FALSE(makeTetrahedra(shape));
  }
  for (const Case& c : cases()) EXPECT_TRUE(tetrahedraOf(c.shape)) << c.name;
}

using Place = std::array<long, 3>;
/// The tetrahedra by their corners' places to a nanometre, as a mirror shows them.
std::multiset<std::set<Place>> placesOf(const TetrahedralMesh& mesh, const Vec3& signs) {
  std::multiset<std::set<Place>> all;
  for (const Tetrahedron& one : mesh.tetrahedra) {
    std::set<Place> corners;
    for (const Vec3& at : cornersOf(mesh, one)) {
      const Vec3 p = 1e9 * at.cwiseProduct(signs);
      corners.insert({std::lround(p.x()), std::lround(p.y()), std::lround(p.z())});
    }
    all.insert(corners);
  }
  return all;
}

// A mesh with a handedness would give the two sides of a symmetric scene different forces.
TEST(Tetrahedra, AreTheirOwnMirrorImages) {
  const Vec3 x(-1, 1, 1), y(1, -1, 1), z(1, 1, -1);
  struct Mirrored {
    SurfaceShape shape;
    std::vector<Vec3> planes;
  };
  const std::vector<Mirrored> all = {{SphereShape{0.03, 3}, {x, y, z}},
                                     {BoxShape{Vec3(0.04, 0.02, 0.03), {4, 2, 6}}, {x, y, z}},
                                     {BoxShape{Vec3(0.04, 0.02, 0.03), {3, 2, 1}}, {y}},
                                     {CapsuleShape{0.008, 0.06, 2}, {x, y, z}},
                                     {CapsuleShape{0.008, 0.001, 3}, {x, y, z}},
                                     {LobesShape{}, {x, z}}};
  for (const Mirrored& one : all) {
    const TetrahedralMesh volume = *makeTetrahedra(one.shape);
    const auto own = placesOf(volume, Vec3(1, 1, 1));
    for (const Vec3& plane : one.planes)
      EXPECT_TRUE(placesOf(volume, plane) == own) << one.shape.index() << ": " << plane.transpose();
  }
}

// Layer k of 2^n has the vertices of a sphere of the share k / 2^n of the radius: 4 k^2 + 2.
TEST(BallTetrahedra, LieInLayersOfEvenThickness) {
  const BallTetrahedra ball = makeBallTetrahedra(0.03, 4);
  ASSERT_EQ(ball.layers, 16);
  std::map<int, int> count;
  for (std::size_t v = 0; v < ball.points.size(); ++v) {
    const double layer = ball.mesh.vertices_m[v].norm() / 0.03 * 16;
    EXPECT_NEAR(layer, std::round(layer), 1e-13);
    ++count[static_cast<int>(std::lround(layer))];
    EXPECT_EQ(ball.vertex(ball.points[v]), static_cast<int>(v));
  }
  EXPECT_EQ(ball.mesh.vertices_m[static_cast<std::size_t>(ball.vertex({0, 0, 0}))], Vec3(0, 0, 0));
  for (int k = 1; k <= 16; ++k) EXPECT_EQ(count[k], 4 * k * k + 2);
}

// Layers of a power of two are the spheres of fewer subdivisions.
TEST(BallTetrahedra, HoldSmallerSpheresOfTheSameKind) {
  const BallTetrahedra ball = makeBallTetrahedra(1, 3);
  for (const int subdivisions : {0, 1, 2}) {
    const double radius = std::pow(0.5, 3 - subdivisions);
    for (const Vec3& wanted : makeSphere(radius, subdivisions).vertices_m) {
      double nearest = 1;
      for (const Vec3& vertex : ball.mesh.vertices_m) nearest = std::min(nearest, (vertex - wanted).norm());
      EXPECT_LT(nearest, 1e-15);
    }
  }
}

TEST(KuhnTetrahedra, FillACubeAroundEachOfItsDiagonals) {
  TetrahedralMesh cube{makeBox({1, 1, 1}).vertices_m, {}};
  for (unsigned start = 0; start < 8; ++start) {
    cube.tetrahedra.clear();
    addKuhnTetrahedra({0, 1, 2, 3, 4, 5, 6, 7}, start, cube.tetrahedra);
    ASSERT_EQ(cube.tetrahedra.size(), 6u);
    EXPECT_EQ(slowBoundary(cube).size(), 12u);
    for (const Tetrahedron& one : cube.tetrahedra) {
      EXPECT_DOUBLE_EQ(signedVolume(cornersOf(cube, one)), 1.0 / 6);
      for (const int end : {static_cast<int>(start), static_cast<int>(start ^ 7U)})
        EXPECT_EQ(std::count(one.begin(), one.end(), end), 1);
    }
  }
}

}  // namespace
}  // namespace fissure::tetrahedra_test
