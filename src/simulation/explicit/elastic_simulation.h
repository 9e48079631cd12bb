#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/scene.h"
#include "scenario/scenario.h"
#include "stepping/simulation.h"

namespace fissure {

/// Builds the world of a run with an elastic body, with its tools at `first_poses` (scene frame): explicit
/// finite elements in substeps, with the pipeline's contacts in each substep, at interpolated tool poses
/// (elastic/METHOD.md 7). Tools that contacts push move in each substep too. The scene must have one body,
/// with a volume, and the pipeline a contact method. Counts and node states of a step are those of its last
/// substep; forces are means over the step. Throws std::invalid_argument where the material or the scene is
/// not valid.
std::unique_ptr<Simulation> makeElasticSimulation(const Scenario& scenario, const PipelineSettings& pipeline,
                                                  const Scene& scene, const std::vector<Pose>& first_poses);

/// The name of the engine, for provenance: "explicit finite elements, double precision".
std::string elasticEngineVersion();

}  // namespace fissure
