#include "measure/same_triangles_roughness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "measure/statistics.h"

namespace fissure::same_triangles_roughness_test {

namespace {

using Forces = std::map<int, std::vector<Vec3>>;  ///< of the colliding triangles, one a law

State stateOf(const Forces& triangles, std::size_t laws) {
  State state;
  state.forces.resize(laws);
  for (const auto& [triangle, forces_N] : triangles) {
    state.colliding_triangles.push_back(triangle);
    for (std::size_t law = 0; law < laws; ++law) {
      state.triangle_forces_N.push_back(forces_N[law]);
      state.forces[law].force_on_tool_N += forces_N[law];
    }
  }
  return state;
}

double roughness(const std::vector<Forces>& steps, std::size_t law, std::size_t laws) {
  SameTrianglesRoughness found(laws);
  for (const Forces& step : steps) found.add(stateOf(step, laws));
  return found.value(law);
}

/// Everything kept, every triangle looked up in every step.
double slowRoughness(const std::vector<Forces>& steps, std::size_t law) {
  double squares = 0, differences = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Vec3 whole_N = Vec3::Zero();
    for (const auto& [triangle, forces_N] : steps[i]) whole_N += forces_N[law];
    squares += whole_N.squaredNorm();
    if (i < 2) continue;
    std::vector<Vec3> sums_N(3, Vec3::Zero());
    for (int triangle = 0; triangle < 100; ++triangle) {
      if (!steps[i].contains(triangle) || !steps[i - 1].contains(triangle) ||
          !steps[i - 2].contains(triangle))
        continue;
      for (std::size_t s = 0; s < 3; ++s) sums_N[s] += steps[i - s].at(triangle)[law];
    }
    differences += std::pow(sums_N[0].norm() - 2 * sums_N[1].norm() + sums_N[2].norm(), 2);
  }
  const auto count = static_cast<double>(steps.size());
  return std::sqrt(differences / (count - 2) / (squares / count));
}

TEST(SameTrianglesRoughness, EqualsALookThroughEverything) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> spread(-1, 1);
  const std::size_t laws = 3;
  std::vector<Forces> steps(60);
  for (Forces& step : steps) {
    for (int triangle = 0; triangle < 40; ++triangle) {
      if (spread(random) < -0.4) continue;
      for (std::size_t law = 0; law < laws; ++law)
        step[triangle].push_back(Vec3(spread(random), 1 + spread(random), spread(random)));
    }
  }
  steps[20].clear();  // no contact at all in one step
  steps[40] = {{99, std::vector<Vec3>(laws, Vec3::UnitX())}};
  for (std::size_t law = 0; law < laws; ++law)
    EXPECT_NEAR(roughness(steps, law, laws), slowRoughness(steps, law), 1e-13) << law;
}

// Nobody comes or goes: 1, 2, 1, 2... newtons on two triangles together, second differences of 2.
TEST(SameTrianglesRoughness, IsTheRoughnessOfTheForceWhereNoTriangleComesOrGoes) {
  std::vector<Forces> steps;
  Roughness plain;
  for (int i = 0; i < 8; ++i) {
    const double force_N = i % 2 == 0 ? 1 : 2;
    plain.add(force_N);
    steps.push_back({{3, {Vec3(0, 0.25 * force_N, 0)}}, {7, {Vec3(0, 0.75 * force_N, 0)}}});
  }
  EXPECT_NEAR(roughness(steps, 0, 1), 2 / std::sqrt(2.5), 1e-15);
  EXPECT_NEAR(roughness(steps, 0, 1), plain.value(), 1e-15);
}

// One triangle grows evenly; others of 5 N enter and leave, and no step shows it.
TEST(SameTrianglesRoughness, LeavesOutWhatEntersAndLeaves) {
  std::vector<Forces> steps;
  Roughness plain;
  for (int i = 0; i < 12; ++i) {
    steps.push_back({{1, {Vec3(0, 1 + 0.5 * i, 0)}}});
    if (i % 3 != 0) steps.back()[10 + i] = {Vec3(0, 5, 0)};
    plain.add(stateOf(steps.back(), 1).forces[0].force_on_tool_N.norm());
  }
  EXPECT_NEAR(roughness(steps, 0, 1), 0, 1e-15);
  EXPECT_GT(plain.value(), 0.3);
}

TEST(SameTrianglesRoughness, IsMissingWhereRoughnessIs) {
  const Forces some = {{1, {Vec3::UnitX()}}};
  EXPECT_TRUE(std::isnan(roughness({some, some}, 0, 1)));
  EXPECT_TRUE(std::isnan(roughness({{}, {}, {}}, 0, 1)));
  EXPECT_EQ(roughness({some, some, some}, 0, 1), 0);
  const Forces unknown = {{1, {Vec3(0, std::nan(""), 0)}}};
  EXPECT_TRUE(std::isnan(roughness({some, some, unknown, some}, 0, 1)));
}

}  // namespace
}  // namespace fissure::same_triangles_roughness_test
