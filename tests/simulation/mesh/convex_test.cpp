#include "mesh/convex.h"

#include <gtest/gtest.h>

#include "mesh/check.h"
#include "mesh/file_surface.h"
#include "mesh/orient.h"
#include "mesh/primitives.h"

namespace fissure::convex_test {

namespace {

TriangleMesh ours(const std::string& name) {
  FileShape shape;
  shape.file = name;
  shape.unit = LengthUnit::mm;
  return loadSurface(shape, FISSURE_SOURCE_DIR "/configs/meshes").mesh;
}

TEST(IsConvex, TellsTheSpatulaFromTheHook) {
  EXPECT_TRUE(isConvex(ours("convex_spatula.obj")));
  EXPECT_FALSE(isConvex(ours("hooked_spatula.obj")));
  EXPECT_TRUE(isConvex(makeSphere(0.03, 3)));
}

TEST(IsConvex, ADentOfAThousandthIsNone) {
  TriangleMesh sphere = makeSphere(0.03, 3);
  sphere.vertices_m[100] *= 0.999;
  EXPECT_TRUE(isConvex(sphere)) << "still outside the plane of its neighbours";
  sphere.vertices_m[100] *= 0.97;
  EXPECT_FALSE(isConvex(sphere));
}

TEST(HasInside, OnlyOfClosedSurfacesThatFaceOutwards) {
  TriangleMesh box = makeBox({0.04, 0.002, 0.015});
  EXPECT_TRUE(hasInside(box));
  TriangleMesh open = box;
  open.faces.pop_back();
  EXPECT_FALSE(hasInside(open));
  for (Face& face : box.faces) std::swap(face[1], face[2]);
  EXPECT_FALSE(hasInside(box));
}

TEST(Mirror, FacesOutwardsAgain) {
  TriangleMesh box = makeBox({0.04, 0.002, 0.015});
  for (Vec3& vertex : box.vertices_m) vertex.x() += 0.1;
  mirror(box);
  EXPECT_TRUE(hasInside(box));
  for (const Vec3& vertex : box.vertices_m) EXPECT_LT(vertex.x(), 0);
}

}  // namespace
}  // namespace fissure::convex_test
