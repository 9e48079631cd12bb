#include "contact/rigid_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/primitives.h"

namespace fissure::rigid_fit_test {

namespace {

SceneBody sphere() {
  return {.name = "sphere", .rest = makeSphere(0.03, 1), .first_vertex = 2};
}

/// The body's vertices, each mapped, behind two vertices of another body.
template <class Map>
std::vector<Vec3> positionsOf(const SceneBody& body, const Map& map) {
  std::vector<Vec3> positions_m(2, Vec3(100, 100, 100));
  for (const Vec3& vertex_m : body.rest.vertices_m) positions_m.push_back(map(vertex_m));
  return positions_m;
}

Vec3 bent(const Vec3& x) {
  return {x.x() + 3 * x.y() * x.z() - 10 * x.y() * x.y(), 0.8 * x.y() + 0.2 * x.x(), x.z() + 0.01};
}

/// What the fit minimises, for any motion back to rest.
template <class Back>
double mismatch(const SceneBody& body, const std::vector<Vec3>& positions_m, const Back& back) {
  double sum = 0;
  for (const Face& face : body.rest.faces) {
    const std::vector<Vec3>& rest_m = body.rest.vertices_m;
    const Vec3 a = rest_m[face[1]] - rest_m[face[0]], b = rest_m[face[2]] - rest_m[face[0]];
    for (const int vertex : face)
      sum += a.cross(b).norm() / 6 * (back(positions_m[2 + vertex]) - rest_m[vertex]).squaredNorm();
  }
  return sum;
}

// No other motion nearby brings the bent body closer to rest, weighted by area.
TEST(RigidFit, IsTheBestOfAllRigidMotions) {
  const SceneBody body = sphere();
  const std::vector<Vec3> positions_m = positionsOf(body, bent);
  RigidFit fit(body);
  fit.fit(positions_m);
  const auto best = [&](const Vec3& p) { return fit.toRest(p); };
  const double least = mismatch(body, positions_m, best);
  EXPECT_GT(least, 0);
  for (int i = 0; i < 6; ++i) {
    const Vec3 way = (i % 2 == 0 ? 1 : -1) * Vec3::Unit(i / 2);
    const Mat3 turn = Eigen::AngleAxisd(0.001, way).toRotationMatrix();
    EXPECT_GT(mismatch(body, positions_m, [&](const Vec3& p) { return Vec3(turn * best(p)); }), least);
    EXPECT_GT(mismatch(body, positions_m, [&](const Vec3& p) { return Vec3(best(p) + 1e-5 * way); }), least);
  }
}

TEST(RigidFit, UndoesAnyRigidMotionToRounding) {
  const SceneBody body = sphere();
  RigidFit fit(body);
  for (const Quat& turn : {Quat(1, 0, 0, 0), Quat(0, 1, 0, 0), Quat(0.1, -0.4, 0.9, 0.2).normalized()}) {
    const std::vector<Vec3> positions_m =
        positionsOf(body, [&](const Vec3& x) { return Vec3(turn * x + Vec3(0.3, -0.2, 0.1)); });
    fit.fit(positions_m);
    for (std::size_t i = 0; i < body.rest.vertices_m.size(); ++i)
      EXPECT_LT((fit.toRest(positions_m[2 + i]) - body.rest.vertices_m[i]).norm(), 1e-15);
  }
}

// A body turned inside out stays deformed: the best map of all would be the mirror image.
TEST(RigidFit, IsNeverAReflection) {
  SceneBody body = sphere();
  for (Vec3& vertex_m : body.rest.vertices_m) vertex_m.z() *= 0.5;
  RigidFit fit(body);
  fit.fit(positionsOf(body, [](const Vec3& x) { return Vec3(x.x(), x.y(), -x.z()); }));
  const Vec3 origin_m = fit.toRest(Vec3::Zero());
  const Vec3 x = fit.toRest(Vec3::UnitX()) - origin_m, y = fit.toRest(Vec3::UnitY()) - origin_m;
  EXPECT_NEAR(x.cross(y).dot(fit.toRest(Vec3::UnitZ()) - origin_m), 1, 1e-12);
}

TEST(RigidFit, OfALostVertexIsNotANumber) {
  const SceneBody body = sphere();
  RigidFit fit(body);
  std::vector<Vec3> positions_m = positionsOf(body, bent);
  positions_m[5].x() = std::nan("");
  fit.fit(positions_m);
  EXPECT_TRUE(fit.toRest(Vec3::Zero()).array().isNaN().all());
}

}  // namespace
}  // namespace fissure::rigid_fit_test
