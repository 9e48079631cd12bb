// Closed surfaces filled by TetGen.
#include "volume/tetgen.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "../mesh/mesh_files.h"
#include "base/error.h"
#include "mesh/check.h"
#include "mesh/primitives.h"
#include "mesh/tetrahedra_check.h"
#include "mesh/tetrahedron.h"
#include "volume/mesh_files.h"

namespace fissure::tetgen_test {

namespace {

/// By the divergence theorem.
double volumeWithin(const TriangleMesh& surface) {
  double volume_m3 = 0;
  for (const auto& [a, b, c] : surface.faces)
    volume_m3 += surface.vertices_m[a].dot(surface.vertices_m[b].cross(surface.vertices_m[c])) / 6;
  return volume_m3;
}

TEST(Tetgen, KeepsTheSurfaceBitForBitAndFillsAllOfIt) {
  const TriangleMesh sphere = makeSphere(0.03, 3);
  const BoundedVolume volume = fillWithTetrahedra(sphere, {});
  EXPECT_EQ(volume.surface.vertices_m, sphere.vertices_m);
  EXPECT_EQ(volume.surface.faces, sphere.faces);
  EXPECT_TRUE(inspectTetrahedra(volume.mesh, sphere).empty());
  EXPECT_NEAR(qualityOf(volume.mesh).volume_m3, volumeWithin(sphere), 1e-12 * volumeWithin(sphere));
  EXPECT_GT(volume.mesh.vertices_m.size(), sphere.vertices_m.size());
  const BoundedVolume again = fillWithTetrahedra(sphere, {});
  EXPECT_EQ(again.mesh.vertices_m, volume.mesh.vertices_m);
  EXPECT_EQ(again.mesh.tetrahedra, volume.mesh.tetrahedra);
}

TEST(Tetgen, MakesNoTetrahedronLargerThanAskedForWhereTheSurfaceAllowsIt) {
  const TriangleMesh box = makeBox(Vec3(0.04, 0.03, 0.02), {1, 1, 1});
  const double edge_m = 0.006, most_m3 = std::pow(edge_m, 3) / (6 * std::sqrt(2.0));
  const BoundedVolume fine = fillWithTetrahedra(box, {.keep_surface = false, .max_edge_m = edge_m});
  for (const Tetrahedron& tetrahedron : fine.mesh.tetrahedra)
    EXPECT_LE(signedVolume(cornersOf(fine.mesh, tetrahedron)), most_m3 * (1 + 1e-9));
  const TriangleMesh sphere = makeSphere(0.03, 4);
  EXPECT_GT(fillWithTetrahedra(sphere, {.max_edge_m = 0.004}).mesh.tetrahedra.size(),
            1.2 * static_cast<double>(fillWithTetrahedra(sphere, {}).mesh.tetrahedra.size()));
}

TEST(Tetgen, MayCutTheSurfaceWhereItIsNotKept) {
  const TriangleMesh box = makeBox(Vec3(0.04, 0.03, 0.002), {1, 1, 1});
  const BoundedVolume cut = fillWithTetrahedra(box, {.keep_surface = false});
  EXPECT_GT(cut.surface.faces.size(), box.faces.size());
  EXPECT_TRUE(inspectTetrahedra(cut.mesh, cut.surface).empty());
  EXPECT_TRUE(inspectSurface(cut.surface).empty());
  EXPECT_NEAR(volumeWithin(cut.surface), volumeWithin(box), 1e-12 * volumeWithin(box));
  const TetrahedraQuality kept = qualityOf(fillWithTetrahedra(box, {}).mesh);
  EXPECT_GT(qualityOf(cut.mesh).worst, kept.worst);
}

TEST(Tetgen, SaysThatASurfaceThatCrossesItselfCannotBeFilled) {
  TriangleMesh crossing = makeBox(Vec3(0.04, 0.03, 0.02), {1, 1, 1});
  const TriangleMesh other = makeBox(Vec3(0.03, 0.04, 0.01), {1, 1, 1});
  for (const Vec3& vertex_m : other.vertices_m)
    crossing.vertices_m.push_back(vertex_m + Vec3(0.01, 0.002, 0.003));
  for (const Face& face : other.faces) crossing.faces.push_back({face[0] + 8, face[1] + 8, face[2] + 8});
  try {
    fillWithTetrahedra(crossing, {});
    FAIL() << "filled";
  } catch (const InputError& error) {
    EXPECT_EQ(
        error.text(),
        "TetGen cannot fill it with tetrahedra, expected a surface that neither crosses nor touches itself");
  }
}

TEST(Tetgen, IsNamedWhereItIsMissing) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  std::string said = "nothing";
  try {
    fillWithTetrahedra(makeSphere(0.03, 1), {});
  } catch (const RunError& error) {
    said = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(said, "filling a surface with tetrahedra needs TetGen (Debian's package tetgen)");
}

TEST(MeshFiles, FillASurfaceOnceAndSayWhoseItIs) {
  const MeshFiles files(".");
  BodySettings body;
  body.name = "liver";
  const TriangleMesh sphere = makeSphere(0.03, 1);
  body.shape = TrianglesShape{sphere.vertices_m, sphere.faces};
  body.model = BodyModel::elastic;
  const BoundedVolume& volume = files.filled(body);
  EXPECT_EQ(&files.filled(body), &volume);
  body.elastic.fill = FillSettings{.max_edge_m = 0.01};
  EXPECT_NE(&files.filled(body), &volume);
  body.shape = TrianglesShape{{}, {}};
  try {
    files.filled(body);
    FAIL() << "filled";
  } catch (const InputError& error) {
    EXPECT_EQ(error.text().substr(0, 21), "bodies.liver.shape: T") << error.text();
  }
}

}  // namespace

}  // namespace fissure::tetgen_test
