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
                                .friction = 0.7,
                                .regions = {{.name = "part", .tag = 3, .viscosity_Pa_s = 4},
                                            {.name = "block",
                                             .box = BoxRegion{{0, 1, 2}, {3, 4, 5}},
                                             .youngs_modulus_Pa = 2e5,
                                             .density_kg_m3 = 1100},
                                            {.name = "vessel",
                                             .capsule = CapsuleRegion{{0, 0, 0}, {0, 0, 1}, 0.002},
                                             .preset = "vessel_wall",
                                             .youngs_modulus_Pa = 626e3,
                                             .poissons_ratio = 0.3,
                                             .density_kg_m3 = 1050}}};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>());
  const Scenario again = parseStoredScenario(toYaml(scenario), "result.h5").scenario;
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

TEST(Elastic, RegionsHaveTheBodysValuesUnlessTheySayOthers) {
  const ElasticSettings liver =
      read(
          "shape: {type: sphere, radius_m: 0.03}, model: elastic, elastic: {preset: liver, viscosity_Pa_s: "
          "2, "
          "material: linear_corotated, mass_damping_1_s: 3, regions: ["
          "{name: wall, capsule: {from_m: [0, 0, 0], to_m: [1, 0, 0], radius_m: 1}, preset: vessel_wall, "
          "poissons_ratio: 0.4}, {name: half, box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}, viscosity_Pa_s: "
          "0}]}")
          .bodies[0]
          .elastic;
  const ElasticSettings wall = liver.materialOf(liver.regions.at(0));
  EXPECT_EQ(wall.material, ElasticMaterialKind::linear_corotated);
  EXPECT_EQ(wall.youngs_modulus_Pa, 626e3);
  EXPECT_EQ(wall.poissons_ratio, 0.4);
  EXPECT_EQ(wall.density_kg_m3, 1050);
  EXPECT_EQ(wall.viscosity_Pa_s, 2);
  EXPECT_EQ(wall.mass_damping_1_s, 3);
  const ElasticSettings half = liver.materialOf(liver.regions.at(1));
  EXPECT_EQ(half.youngs_modulus_Pa, 5.4e3);
  EXPECT_EQ(half.viscosity_Pa_s, 0);
}

TEST(Elastic, RegionsOutOfRangeAreRefused) {
  const ElasticRegion good = {.name = "part", .box = BoxRegion{{0, 0, 0}, {1, 1, 1}}};
  const auto problems = [&](const auto& change) {
    Scenario scenario = elastic();
    scenario.bodies[0].elastic.regions = {good};
    change(scenario.bodies[0].elastic.regions);
    return pathsOf(validate(scenario));
  };
  using Regions = std::vector<ElasticRegion>;
  const std::string path = "bodies.ball.elastic.regions";
  using Paths = std::vector<std::string>;
  EXPECT_EQ(problems([](Regions&) {}), Paths());
  EXPECT_EQ(problems([](Regions& r) { r[0].box.reset(); }), Paths{path + ".part"});
  EXPECT_EQ(problems([](Regions& r) { r[0].tag = 1; }), Paths{path + ".part"});
  EXPECT_EQ(problems([](Regions& r) { r[0].box->min_m.x() = 2; }), Paths{path + ".part.box.min_m"});
  EXPECT_EQ(problems([](Regions& r) { r.push_back(r[0]); }), Paths{path + ".1.name"});
  EXPECT_EQ(problems([](Regions& r) { r[0].name = "a b"; }), Paths{path + ".0.name"});
  EXPECT_EQ(problems([](Regions& r) { r[0].youngs_modulus_Pa = 0; }),
            Paths{path + ".part.youngs_modulus_Pa"});
  EXPECT_EQ(problems([](Regions& r) { r[0].poissons_ratio = 0.49995; }),
            Paths{path + ".part.poissons_ratio"});
  EXPECT_EQ(problems([](Regions& r) { r[0].density_kg_m3 = nan; }), Paths{path + ".part.density_kg_m3"});
  EXPECT_EQ(problems([](Regions& r) { r[0].viscosity_Pa_s = -1; }), Paths{path + ".part.viscosity_Pa_s"});
  EXPECT_EQ(problems([](Regions& r) { r[0].preset = "livver"; }), Paths{path + ".part.preset"});
  const auto capsule = [&](const CapsuleRegion& region) {
    return problems([&](Regions& r) {
      r[0].box.reset();
      r[0].capsule = region;
    });
  };
  EXPECT_EQ(capsule({{0, 0, 0}, {1, 0, 0}, 0.1}), Paths());
  EXPECT_EQ(capsule({{0, 0, 0}, {1, 0, 0}, 0}), Paths{path + ".part.capsule.radius_m"});
  EXPECT_EQ(capsule({{0, nan, 0}, {1, 0, 0}, 1}), Paths{path + ".part.capsule.from_m"});
  EXPECT_EQ(capsule({{0, 0, 0}, {1, 0, infinity}, 1}), Paths{path + ".part.capsule.to_m"});
  const auto many = [&](std::size_t count) {
    return problems([&](Regions& r) {
      r.assign(count, good);
      for (std::size_t i = 0; i < count; ++i) r[i].name = "part" + std::to_string(i);
    });
  };
  EXPECT_EQ(many(most_regions), Paths());
  EXPECT_EQ(many(most_regions + 1), Paths{path});
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
  scenario.bodies[0].elastic.poissons_ratio = 0.49995;
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
  EXPECT_TRUE(validate(scenario).empty());
  scenario.bodies[0].elastic.fill =
      FillSettings{.radius_edge_ratio = 1, .least_dihedral_deg = 90, .max_edge_m = 0};
  const std::string fill = "bodies.ball.elastic.fill";
  EXPECT_EQ(pathsOf(validate(scenario)),
            (std::vector{fill + ".radius_edge_ratio", fill + ".least_dihedral_deg", fill + ".max_edge_m"}));

  scenario = elastic();
  scenario.bodies[0].elastic.fill = FillSettings();
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{fill});

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

TEST(Elastic, BulletsDeformableWorldTakesOneElasticBodyInDoublePrecision) {
  Scenario scenario = elastic();
  PipelineSettings entry{.name = "d", .pipeline = PipelineKind::deformable};
  scenario.pipelines = {entry};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>());
  scenario.ground = GroundSettings{};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>()) << "a box of Bullet";
  scenario.pipelines[0].precision = Precision::f32;
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"pipelines.d.precision"});

  scenario.pipelines[0] = entry;
  scenario.bodies[0].model = BodyModel::shell;
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"pipelines.d.pipeline"});

  scenario = elastic();
  scenario.pipelines = {entry};
  scenario.bodies[0].elastic.mass_damping_1_s = 1;
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"pipelines.d.pipeline"});
  scenario.bodies[0].elastic.material = ElasticMaterialKind::linear_corotated;
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>());
  scenario.bodies[0].elastic.material = ElasticMaterialKind::saint_venant_kirchhoff;
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"pipelines.d.pipeline"});
  scenario.bodies[0].elastic.material = ElasticMaterialKind::linear_corotated;
  scenario.bodies[0].elastic.regions = {{.name = "part", .box = BoxRegion{{0, 0, 0}, {1, 1, 1}}}};
  EXPECT_EQ(pathsOf(validate(scenario)), std::vector<std::string>{"pipelines.d.pipeline"});
}

TEST(Elastic, SolverSettingsOfBulletsDeformableWorldAreChecked) {
  const auto pathsWith = [](const auto& set) {
    Scenario scenario = elastic();
    scenario.pipelines = {{.name = "d", .pipeline = PipelineKind::deformable}};
    set(scenario.pipelines[0].deformable);
    return pathsOf(validate(scenario));
  };
  using Paths = std::vector<std::string>;
  const std::string in = "pipelines.d.deformable.";
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.substeps = 0; }), Paths{in + "substeps"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.krylov_iterations = 0; }), Paths{in + "krylov_iterations"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.krylov_tolerance = -1; }), Paths{in + "krylov_tolerance"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.contact_iterations = 0; }),
            Paths{in + "contact_iterations"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.contact_tolerance = -1; }),
            Paths{in + "contact_tolerance"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.error_reduction = 1.5; }), Paths{in + "error_reduction"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.max_error_reduction_m_s = 0; }),
            Paths{in + "max_error_reduction_m_s"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.constraint_mixing = 2; }), Paths{in + "constraint_mixing"});
  // Of Newton's method, which explicit steps have not.
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.line_search = true; }), Paths{in + "line_search"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.newton_iterations = 5; }), Paths{in + "newton_iterations"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) { s.newton_tolerance = 1e-9; }),
            Paths{in + "newton_tolerance"});
  EXPECT_EQ(pathsWith([](DeformableSolver& s) {
              s.implicit = true;
              s.line_search = true;
              s.newton_iterations = 5;
              s.newton_tolerance = 1e-9;
            }),
            Paths{});
}

}  // namespace

}  // namespace fissure::elastic_test
