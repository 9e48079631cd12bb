// Simulations whose tools change their speed between two steps, as those of a pilot do.
#include <gtest/gtest.h>

#include "engine/simulation.h"
#include "explicit/elastic_simulation.h"
#include "scene/build_scene.h"

namespace fissure::tempo_test {

namespace {

struct Engine {
  const char* name;
  BodyModel model;
  PipelineKind pipeline;
  decltype(&makeSimulation) make;
};

class Tempo : public testing::TestWithParam<Engine> {};

// A ball that falls freely has half its velocity and what gravity gives it in a step; faster tools let it be.
TEST_P(Tempo, TissueSlowsDownWithItsTools) {
  Scenario scenario;
  scenario.time.step_s = 0.001;
  scenario.bodies.resize(1);
  scenario.bodies[0].name = "ball";
  scenario.bodies[0].shape = SphereShape{.radius_m = 0.03, .subdivisions = 1};
  scenario.bodies[0].model = GetParam().model;
  scenario.pipelines = {{.name = "run", .pipeline = GetParam().pipeline}};
  const Scene scene = buildScene(scenario, false);
  const auto simulation = GetParam().make(scenario, scenario.pipelines[0], scene, {});
  const auto fall_m_s = [&] {
    simulation->step({});
    return -simulation->state().velocities_m_s[0].y();
  };
  double before_m_s = 0;
  for (int step = 0; step < 50; ++step) before_m_s = fall_m_s();
  EXPECT_NEAR(before_m_s, 0.4905, 0.005);
  simulation->changeTempo(2);
  EXPECT_NEAR(fall_m_s(), before_m_s + 0.00981, 0.002);
  simulation->changeTempo(0.5);
  EXPECT_NEAR(fall_m_s(), (before_m_s + 0.00981) / 2 + 0.00981, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Engines, Tempo,
                         testing::Values(Engine{"springs", BodyModel{}, PipelineKind::swept, &makeSimulation},
                                         Engine{"elastic", BodyModel::elastic, PipelineKind::swept,
                                                &makeElasticSimulation},
                                         Engine{"deformable", BodyModel::elastic, PipelineKind::deformable,
                                                &makeDeformableSimulation}),
                         [](const auto& engine) { return engine.param.name; });

}  // namespace

}  // namespace fissure::tempo_test
