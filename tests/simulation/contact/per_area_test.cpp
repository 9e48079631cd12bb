// A sphere indented by a prescribed map: what the sum over triangles becomes as the mesh is refined.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include "contact/triangle_forces.h"
#include "mesh/primitives.h"

namespace fissure::per_area_test {

namespace {

constexpr double kRadius_m = 0.03, kDepth_m = 0.005, kEdge_m = 0.01;
constexpr double kStiffness = 2e6, kExponent = 1.3;

/// Points of the sphere above y = kEdge_m go down, the top by kDepth_m, smoothly to 0 at the edge.
double indentation(double y_m) {
  const double inside = std::max(0.0, (y_m - kEdge_m) / (kRadius_m - kEdge_m));
  return kDepth_m * inside * inside;
}

/// The whole sphere goes down, in contact or not.
double wholeMotion(double) {
  return kDepth_m;
}

/// The integral of k x^n over the sphere above y = kEdge_m, where contact is: zones of equal height have
/// equal area (Archimedes). Simpson's rule.
double surfaceIntegral(double (*down_m)(double)) {
  const int intervals = 100'000;
  const double h = (kRadius_m - kEdge_m) / intervals;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * std::pow(down_m(kEdge_m + i * h), kExponent);
  }
  return kStiffness * 2 * std::numbers::pi * kRadius_m * sum * h / 3;
}

struct Totals {
  double paper_N, per_area_N;
};

Totals totalsOn(int subdivisions, double (*map_m)(double)) {
  Scene scene;
  scene.bodies.push_back({.name = "sphere", .rest = makeSphere(kRadius_m, subdivisions)});
  scene.tools.resize(1);
  State state;
  ContactPatch patch;
  patch.resize(scene.vertexCount(), scene.faceCount(), 1);
  patch.clear();
  for (const Vec3& rest_m : scene.bodies[0].rest.vertices_m) {
    const double down_m = map_m(rest_m.y());
    const int vertex = static_cast<int>(state.positions_m.size());
    if (rest_m.y() > kEdge_m) patch.touchVertex(0, vertex, 1, -Vec3::UnitY(), down_m);
    state.positions_m.push_back(rest_m - Vec3(0, down_m, 0));
    state.velocities_m_s.push_back(Vec3::Zero());
  }
  std::vector<TriangleLaw> laws;
  laws.push_back({ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 0, .n = kExponent})});
  laws.push_back({.law = ForceLaw(ForceModel::hunt_crossley, {.k = kStiffness, .lambda = 0, .n = kExponent}),
                  .per_area = true});
  TriangleForces(scene, std::move(laws), 0.001).evaluate(patch, state);
  return {state.forces[0].force_on_tool_N.y(), state.forces[1].force_on_tool_N.y()};
}

// Each refinement halves the edges: an error of second order falls to a quarter. Measured: 9.1, 2.5, 0.64 and
// 0.16 % of 2.137 N on 128, 512, 2,048 and 8,192 triangles; the paper's sum 2.4, 10.1, 40.9 and 164 N.
TEST(PerArea, ConvergesToTheSurfaceIntegralWhileThePapersSumGrows) {
  const double exact_N = surfaceIntegral(indentation);
  double last_error = 0, last_paper_N = 0;
  std::ostringstream table;
  table << "triangles,exact_N,per_area_N,paper_N\n";
  for (const int subdivisions : {2, 3, 4, 5}) {
    const Totals totals = totalsOn(subdivisions, indentation);
    table << 8 * (1 << (2 * subdivisions)) << ',' << exact_N << ',' << totals.per_area_N << ','
          << totals.paper_N << '\n';
    const double error = std::abs(totals.per_area_N / exact_N - 1);
    if (subdivisions > 2) {
      EXPECT_NEAR(last_error / error, 4, 0.5) << subdivisions;
      EXPECT_NEAR(totals.paper_N / last_paper_N, 4, 0.3) << subdivisions;
    }
    last_error = error;
    last_paper_N = totals.paper_N;
  }
  EXPECT_LT(last_error, 0.002);
  if (const char* file = std::getenv("FISSURE_PER_AREA_TABLE")) std::ofstream(file) << table.str();
}

// Triangles with one vertex in contact count whole: a strip around the contact as wide as they are, that
// carries force where tissue moves beyond the contact too. Measured on 128 to 32,768 triangles: 43, 18, 3.4,
// 3.6 and 2.3 % too much, ragged by how the edge of contact falls between rows of vertices; order 1.05.
TEST(PerArea, ConvergesWithFirstOrderWhereTissueMovesBeyondTheContact) {
  const double exact_N = surfaceIntegral(wholeMotion);
  const double coarse = totalsOn(2, wholeMotion).per_area_N / exact_N - 1;
  const double fine = totalsOn(6, wholeMotion).per_area_N / exact_N - 1;
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, 0.03);
  EXPECT_NEAR(std::log2(coarse / fine) / 4, 1, 0.2);
}

}  // namespace
}  // namespace fissure::per_area_test
