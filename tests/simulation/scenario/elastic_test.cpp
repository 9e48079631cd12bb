// Bodies with a modulus in a scenario: their keys, their presets, and what they are refused with.
#include "scenario/elastic.h"

#include <gtest/gtest.h>

#include <string>

#include "scenario/load.h"
#include "validate_changes.h"

namespace fissure::elastic_test {

namespace {

/// A scenario with one elastic body whose pipelines and ground are good.
Scenario elastic() {
  Scenario scenario;
  scenario.format = 1;
  scenario.name = "elastic";
  scenario.time.duration_s = 1;
  scenario.bodies.resize(1);
  scenario.bodies[0].name = "ball";
  scenario.bodies[0].shape = SphereShape{};
  scenario.bodies[0].model = BodyModel::elastic;
  scenario.pipelines = {{.name = "swept", .pipeline = PipelineKind::swept}};
  return scenario;
}

Scenario read(const std::string& body) {
  return parseScenario("format: 1\nname: s\ntime: {duration_s: 1}\nbodies:\n  - {name: ball, " + body +
                           "}\npipelines:\n  - {pipeline: swept}\n",
                       "s.yaml")
      .scenario;
}

std::vector<std::string> pathsOf(const std::vector<Problem>& problems) {
  std::vector<std::string> paths;
  for (const Problem& problem : problems) paths.push_back(problem.path);
  return paths;
}

TEST(Elastic, IsGoodAndRoundTrips) {
  Scenario scenario = elastic();
  scenario.bodies[0].elastic = {.preset = "liver",
                                .material = ElasticMaterialKind::linear_corotated,
                                .youngs_modulus_Pa = 1234.5,
                                .poissons_ratio = 0.25,
                                .density_kg_m3 = 999,
                                .viscosity_Pa_s = 0.5,
                                .mass_damping_1_s = 2,
                                .friction = 0.7};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>());
  const Scenario again = parseStoredScenario(toYaml(scenario)).scenario;
  EXPECT_EQ(again.bodies[0].model, BodyModel::elastic);
  EXPECT_EQ(again.bodies[0].elastic, scenario.bodies[0].elastic);
}

TEST(Elastic, APresetFillsWhatTheFileLeavesOut) {
  const std::string shape = "shape: {type: sphere, radius_m: 0.03}, model: elastic, ";
  const ElasticSettings liver = read(shape + "elastic: {preset: liver}").bodies[0].elastic;
  EXPECT_EQ(liver.youngs_modulus_Pa, 5.4e3);
  EXPECT_EQ(liver.density_kg_m3, 1060);
  const ElasticSettings changed =
      read(shape + "elastic: {youngs_modulus_Pa: 7000, preset: liver}").bodies[0].elastic;
  EXPECT_EQ(changed.youngs_modulus_Pa, 7000);
  EXPECT_EQ(changed.poissons_ratio, 0.49);
}

TEST(Elastic, EveryPresetIsAGoodMaterialWithASource) {
  for (const ElasticPreset& preset : elasticPresets()) {
    Scenario scenario = elastic();
    scenario.bodies[0].elastic.preset = std::string(preset.name);
    applyPreset(scenario.bodies[0].elastic);
    EXPECT_EQ(scenario.bodies[0].elastic.youngs_modulus_Pa, preset.youngs_modulus_Pa);
    EXPECT_TRUE(validate(scenario).empty()) << preset.name;
    EXPECT_NE(preset.description.find(':'), std::string_view::npos) << preset.name;
  }
}

TEST(Elastic, KeysOfTheOtherModelHaveNoMeaning) {
  EXPECT_THROW(read("shape: {type: sphere, radius_m: 0.03}, model: elastic, mass_kg: 1"), InputError);
  EXPECT_THROW(read("shape: {type: sphere, radius_m: 0.03}, model: elastic, solver: {damping: 0.1}"),
               InputError);
  EXPECT_THROW(read("shape: {type: sphere, radius_m: 0.03}, elastic: {youngs_modulus_Pa: 1}"), InputError);
  EXPECT_THROW(read("shape: {type: sphere, radius_m: 0.03}, model: jelly"), InputError);
}

TEST(Elastic, MaterialsOutOfRangeAreRefused) {
  for (double ElasticSettings::*member :
       {&ElasticSettings::youngs_modulus_Pa, &ElasticSettings::density_kg_m3}) {
    for (const double bad : {0.0, -1.0, nan, infinity}) {
      Scenario scenario = elastic();
      scenario.bodies[0].elastic.*member = bad;
      EXPECT_EQ(validate(scenario).size(), 1u) << bad;
    }
  }
  for (double ElasticSettings::*member :
       {&ElasticSettings::viscosity_Pa_s, &ElasticSettings::mass_damping_1_s, &ElasticSettings::friction,
        &ElasticSettings::poissons_ratio}) {
    for (const double bad : {-0.1, nan, infinity}) {
      Scenario scenario = elastic();
      scenario.bodies[0].elastic.*member = bad;
      EXPECT_EQ(validate(scenario).size(), 1u) << bad;
    }
  }
  Scenario scenario = elastic();
  scenario.bodies[0].elastic.poissons_ratio = 0.495;
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"bodies.ball.elastic.poissons_ratio"});
}

TEST(Elastic, WhatItsEngineHasNotIsRefused) {
  Scenario scenario = elastic();
  scenario.bodies.push_back(scenario.bodies[0]);
  scenario.bodies[1].name = "other";
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"bodies.ball.model"});
  scenario.bodies[1].model = BodyModel::shell;
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"bodies.ball.model"});

  scenario = elastic();
  scenario.bodies[0].shape = TrianglesShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"bodies.ball.shape"});

  scenario = elastic();
  scenario.bodies[0].shape = SphereShape{.radius_m = 0.03, .subdivisions = 6};
  EXPECT_TRUE(validate(scenario).empty());
  scenario.bodies[0].shape = SphereShape{.radius_m = 0.03, .subdivisions = 7};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"bodies.ball.shape"});

  scenario = elastic();
  scenario.pipelines = {{.name = "sdf", .pipeline = PipelineKind::default_sdf},
                        {.name = "clusters", .pipeline = PipelineKind::cluster},
                        {.name = "nodes", .pipeline = PipelineKind::fukuhara},
                        {.name = "single", .pipeline = PipelineKind::swept, .precision = Precision::f32}};
  EXPECT_EQ(pathsOf(validate(scenario)),
            (std::vector<std::string>{"pipelines.sdf.pipeline", "pipelines.clusters.pipeline",
                                      "pipelines.single.precision"}));

  scenario = elastic();
  scenario.pipelines = {{.name = "rays", .pipeline = PipelineKind::raycast}};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"pipelines.rays.response"});
  scenario.pipelines[0].response = ContactResponse::momentum;
  EXPECT_TRUE(validate(scenario).empty());

  scenario = elastic();
  scenario.world.air_density_kg_m3 = 1;
  scenario.world.max_displacement_m = 1;
  scenario.ground = GroundSettings{.height_m = 0, .hardness = 1};
  EXPECT_EQ(
      pathsOf(validate(scenario)),
      (std::vector<std::string>{"world.air_density_kg_m3", "world.max_displacement_m", "ground.hardness"}));

  scenario = elastic();
  scenario.ground = GroundSettings{};
  EXPECT_TRUE(validate(scenario).empty());
  scenario.pipelines.push_back({.name = "nodes", .pipeline = PipelineKind::fukuhara});
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"pipelines.nodes.ground_contact"});
  scenario.pipelines[1].ground_contact = GroundKind::half_space;
  EXPECT_TRUE(validate(scenario).empty());
}

}  // namespace

}  // namespace fissure::elastic_test
