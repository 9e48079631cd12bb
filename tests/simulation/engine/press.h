#pragma once

#include <memory>

#include "contact/grid_nodes.h"
#include "engine/simulation.h"
#include "mesh/primitives.h"
#include "scene/place.h"

namespace fissure::simulation_test {

/// A sphere on the ground under a spatula, with one Hunt-Crossley law.
inline Scenario press() {
  Scenario scenario;
  scenario.ground = GroundSettings{};
  BodySettings body;
  body.name = "sphere";
  body.shape = SphereShape{};
  body.position_m = Vec3(0, 0.03, 0);
  body.material.linear_stiffness = 0.5;
  body.solver.damping = 0.01;
  body.solver.pose_matching = 0.02;
  body.solver.dynamic_friction = 0.5;
  body.solver.position_iterations = 10;
  scenario.bodies = {body};
  ToolSettings tool;
  tool.name = "spatula";
  scenario.tools = {tool};
  scenario.force = {{.name = "hc", .model = ForceModel::hunt_crossley}};
  return scenario;
}

/// The scene of a scenario of box tools.
inline Scene sceneOf(const Scenario& scenario, bool with_nodes) {
  Scene scene;
  for (const BodySettings& body : scenario.bodies)
    scene.bodies.push_back({.name = body.name,
                            .rest = placeBody(body),
                            .first_vertex = scene.vertexCount(),
                            .first_face = scene.faceCount()});
  for (const ToolSettings& tool : scenario.tools) {
    scene.tools.push_back({.name = tool.name,
                           .surface = makeSurface(tool.shape),
                           .box_size_m = std::get<BoxShape>(tool.shape).size_m});
    if (with_nodes)
      scene.tools.back().nodes = makeGridNodes(std::get<BoxShape>(tool.shape).size_m, tool.nodes.resolution);
  }
  return scene;
}

inline Pose at(double y) {
  return {.position_m = Vec3(0, y, 0), .orientation = Quat::Identity()};
}

/// The spatula's middle goes from y = 0.0615 down by 0.2 mm a step.
class Press {
 public:
  explicit Press(PipelineKind pipeline, SettingsPreset settings = SettingsPreset::tuned)
      : scenario_(press()),
        entry_{.name = "p", .pipeline = pipeline, .settings = settings},
        scene_(sceneOf(scenario_, entry_.usesNodes())),
        simulation_(makeSimulation(scenario_, entry_, scene_, {at(0.0615)})) {}
  const State& step() {
    simulation_->step({at(0.0615 - 0.0002 * ++steps_)});
    return simulation_->state();
  }
  const State& run(int steps) {
    for (int i = 0; i < steps; ++i) step();
    return simulation_->state();
  }
  Simulation& simulation() { return *simulation_; }

 private:
  Scenario scenario_;
  PipelineSettings entry_;
  Scene scene_;
  std::unique_ptr<Simulation> simulation_;
  int steps_ = 0;
};

}  // namespace fissure::simulation_test
