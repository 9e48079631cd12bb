// Regions of a body: their masses, what the plan says of them, and what a stiff one does to a press.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "scene/build_scene.h"
#include "stepping/elastic_model.h"
#include "stepping/substep_plan.h"

namespace fissure::elastic_regions_test {

namespace {

/// A block of 4 x 4 x 4 cells whose upper half is a region, where there is one.
Scenario block(const std::optional<ElasticRegion>& upper) {
  Scenario scenario;
  scenario.bodies.resize(1);
  BodySettings& body = scenario.bodies[0];
  body.name = "block";
  body.shape = BoxShape{.size_m = {0.04, 0.04, 0.04}, .cells = {4, 4, 4}};
  body.model = BodyModel::elastic;
  if (upper) body.elastic.regions = {*upper};
  return scenario;
}

ElasticRegion upperHalf() {
  return {.name = "upper", .box = BoxRegion{{-1, 0, -1}, {1, 1, 1}}};
}

SubstepPlan planOf(const Scenario& scenario) {
  return planSubsteps(scenario.bodies[0], buildScene(scenario, false).bodies[0], 1e-3);
}

TEST(ElasticRegions, HaveTheirOwnDensity) {
  ElasticRegion heavy = upperHalf();
  heavy.density_kg_m3 = 3000;
  const Scenario scenario = block(heavy);
  const ElasticTissue tissue =
      makeTissue(scenario.bodies[0], buildScene(scenario, false).bodies[0], Vec3::Zero());
  const double mass_kg = std::accumulate(tissue.masses_kg().begin(), tissue.masses_kg().end(), 0.0);
  EXPECT_NEAR(mass_kg, 2000 * 6.4e-5, 1e-12);
}

TEST(ElasticRegions, OfTheBodysMaterialChangeNothing) {
  const SubstepPlan plain = planOf(block({})), same = planOf(block(upperHalf()));
  EXPECT_EQ(plain.critical_step_s, same.critical_step_s);
  EXPECT_TRUE(plain.regions.empty());
  EXPECT_EQ(same.regions.at(0).tetrahedra, 192u);
  EXPECT_EQ(same.regions.at(0).critical_step_s, same.critical_step_s);
}

// A hundred times the modulus asks for ten times the substeps.
TEST(ElasticRegions, AStiffOneSetsTheSubsteps) {
  ElasticRegion stiff = upperHalf();
  stiff.youngs_modulus_Pa = 1e6;
  const SubstepPlan plain = planOf(block({})), mixed = planOf(block(stiff));
  EXPECT_NEAR(mixed.critical_step_s, plain.critical_step_s / 10, 0.03 * plain.critical_step_s / 10);
  EXPECT_GT(mixed.substeps, 6 * plain.substeps);  // the plain one needs less than one
  EXPECT_GE(mixed.regions.at(0).critical_step_s, mixed.critical_step_s);
  EXPECT_NEAR(mixed.regions.at(0).critical_step_s, mixed.critical_step_s, 0.03 * mixed.critical_step_s);
}

}  // namespace

}  // namespace fissure::elastic_regions_test
