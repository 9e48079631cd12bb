#include "mesh/tetrahedra_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/primitives.h"
#include "mesh/tetrahedra.h"
#include "mesh/tetrahedron.h"

namespace fissure::tetrahedra_check_test {

namespace {

using Lines = std::vector<std::string>;
constexpr int kCentre = 26;  ///< the one vertex inside

/// A cube of 2 x 2 x 2 cells, 2 m on edge: 27 vertices, 48 tetrahedra.
struct Cube {
  TriangleMesh surface = makeBox({2, 2, 2}, {2, 2, 2});
  TetrahedralMesh volume = makeBoxTetrahedra({2, 2, 2}, {2, 2, 2});

  Lines lines() const {
    Lines all;
    for (const VolumeDefect& defect : inspectTetrahedra(volume, surface)) all.push_back(defect.text);
    return all;
  }
};

TEST(InspectTetrahedra, FindsNothingWrongWithAGoodVolume) {
  EXPECT_EQ(Cube().lines(), Lines{});
}

TEST(InspectTetrahedra, SaysThatAVolumeIsEmpty) {
  Cube cube;
  cube.volume.tetrahedra.clear();
  EXPECT_EQ(cube.lines(), Lines{"no tetrahedra (the volume is empty)"});
}

TEST(InspectTetrahedra, CountsIndicesOutOfRange) {
  Cube cube;
  cube.volume.tetrahedra.push_back({0, 1, 2, 27});
  cube.volume.tetrahedra.push_back({-1, 1, 2, 3});
  EXPECT_EQ(cube.lines(),
            Lines{"2 tetrahedra with an index out of range (there are 27 vertices, counted from 0)"});
}

TEST(InspectTetrahedra, CountsNonFiniteVertices) {
  Cube cube;
  cube.volume.vertices_m[kCentre].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cube.lines(), Lines{"1 non-finite vertex (a coordinate is infinite or not a number)"});
}

TEST(InspectTetrahedra, CountsUnusedVertices) {
  Cube cube;
  cube.volume.vertices_m.insert(cube.volume.vertices_m.end(), 2, Vec3(0, 0, 0));
  EXPECT_EQ(cube.lines(), Lines{"2 unused vertices (part of no tetrahedron)"});
}

// All 48 tetrahedra meet in the centre; moved out by one side, those on its eight triangles turn over.
TEST(InspectTetrahedra, CountsInvertedTetrahedra) {
  Cube cube;
  cube.volume.vertices_m[kCentre] = Vec3(1.5, 0.1, 0.2);
  EXPECT_EQ(cube.lines(), Lines{"8 inverted tetrahedra (of negative volume)"});
}

TEST(InspectTetrahedra, CountsFlatTetrahedra) {
  Cube cube;
  cube.volume.vertices_m[kCentre] = Vec3(1, 0.1, 0.2);  // in the plane of one side
  EXPECT_EQ(cube.lines(), Lines{"8 flat tetrahedra (without volume)"});
  Cube other;
  other.volume.tetrahedra.push_back({3, 4, 3, 5});
  EXPECT_EQ(other.lines(), Lines{"1 flat tetrahedron (without volume)"});
}

TEST(InspectTetrahedra, CountsSliversWhichCanBeSimulated) {
  Cube cube;
  for (std::vector<Vec3>* vertices : {&cube.surface.vertices_m, &cube.volume.vertices_m})
    for (Vec3& vertex : *vertices) vertex.y() *= 1e-3;
  EXPECT_EQ(cube.lines(), Lines{"48 sliver tetrahedra (radius ratio below 0.01, where a regular one has 1)"});
  EXPECT_FALSE(spoilsVolume(VolumeDefectKind::sliver_tetrahedra));
  EXPECT_TRUE(spoilsVolume(VolumeDefectKind::inverted_tetrahedra));
}

// A tetrahedron given twice: its three sides inside have three owners, the one outside two on the same side.
TEST(InspectTetrahedra, CountsOverlappingSides) {
  Cube cube;
  cube.volume.tetrahedra.push_back(cube.volume.tetrahedra[7]);
  EXPECT_EQ(cube.lines(),
            (Lines{"4 overlapping sides (of more than two tetrahedra, or of two on the same side of it)",
                   "1 other boundary triangle (of the boundary and not of the surface, or the other way "
                   "round)"}));
}

TEST(InspectTetrahedra, CountsVerticesThatAreNotTheSurfaces) {
  Cube cube;
  cube.volume.vertices_m[5].z() = std::nextafter(cube.volume.vertices_m[5].z(), 10);
  EXPECT_EQ(cube.lines(), Lines{"1 other vertex (not where the surface's vertex of the same number is)"});
}

// Without one tetrahedron its side outside is missing, and its three sides inside are bare.
TEST(InspectTetrahedra, CountsTrianglesThatAreNotTheSurfaces) {
  Cube cube;
  cube.volume.tetrahedra.erase(cube.volume.tetrahedra.begin() + 7);
  EXPECT_EQ(cube.lines(), Lines{"4 other boundary triangles (of the boundary and not of the surface, or the "
                                "other way round)"});
}

TEST(InspectTetrahedra, CountsPieces) {
  Cube cube;
  const TetrahedralMesh other = cube.volume;
  const int first = static_cast<int>(cube.volume.vertices_m.size());
  for (const Vec3& vertex : other.vertices_m) cube.volume.vertices_m.push_back(vertex + Vec3(3, 0, 0));
  for (const auto& [a, b, c, d] : other.tetrahedra)
    cube.volume.tetrahedra.push_back({first + a, first + b, first + c, first + d});
  const Lines lines = cube.lines();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "48 other boundary triangles (of the boundary and not of the surface, or the other way "
            "round)");
  EXPECT_EQ(lines[1], "2 pieces (that share no side of a tetrahedron)");
}

// The shapes of which the ratio is known in closed form.
TEST(RadiusRatio, IsOneForARegularTetrahedronAndNoneForAFlatOne) {
  const std::array<Vec3, 4> regular = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  const std::array<Vec3, 4> turned_over = {regular[0], regular[2], regular[1], regular[3]};
  const double sign = signedVolume(regular) > 0 ? 1 : -1;
  EXPECT_DOUBLE_EQ(sign * radiusRatio(regular), 1);
  EXPECT_DOUBLE_EQ(sign * radiusRatio(turned_over), -1);
  EXPECT_DOUBLE_EQ(std::abs(signedVolume(regular)), 8.0 / 3);
  EXPECT_DOUBLE_EQ(std::abs(relativeVolume(regular)), std::sqrt(0.5));
  const std::array<Vec3, 4> corner = {Vec3(5, 5, 5), Vec3(5.5, 5, 5), Vec3(5, 5.5, 5), Vec3(5, 5, 5.5)};
  EXPECT_NEAR(radiusRatio(corner), std::sqrt(3.0) - 1, 1e-15);
  const std::array<Vec3, 4> kuhn = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1)};
  EXPECT_NEAR(radiusRatio(kuhn), 3 / (1 + std::sqrt(2.0)) / std::sqrt(3.0), 1e-15);
  const std::array<Vec3, 4> flat = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)};
  EXPECT_EQ(radiusRatio(flat), 0);
  EXPECT_EQ(relativeVolume(flat), 0);
  const std::array<Vec3, 4> point = {flat[1], flat[1], flat[1], flat[1]};
  EXPECT_EQ(radiusRatio(point), 0);
  EXPECT_EQ(relativeVolume(point), 0);
}

TEST(QualityOf, TellsWorstMeanAndVolume) {
  const TetrahedraQuality cube = qualityOf(Cube().volume);
  const double kuhn = 3 / (1 + std::sqrt(2.0)) / std::sqrt(3.0);
  EXPECT_NEAR(cube.worst, kuhn, 1e-15);
  EXPECT_NEAR(cube.mean, kuhn, 1e-14);
  EXPECT_DOUBLE_EQ(cube.volume_m3, 8);
  EXPECT_EQ(qualityOf({}).volume_m3, 0);
}

}  // namespace
}  // namespace fissure::tetrahedra_check_test
