#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/scene.h"
#include "scenario/scenario.h"
#include "stepping/simulation.h"

namespace fissure {

/// Builds the Bullet world of one run with its tools at `first_poses` (scene frame). Throws
/// std::invalid_argument for a pipeline that this engine does not have.
std::unique_ptr<Simulation> makeSimulation(const Scenario& scenario, const PipelineSettings& pipeline,
                                           const Scene& scene, const std::vector<Pose>& first_poses);

/// The same for a body of model elastic, in Bullet's deformable world (pipeline deformable). Tools cannot be
/// pushed. Throws std::invalid_argument for another pipeline.
std::unique_ptr<Simulation> makeDeformableSimulation(const Scenario& scenario,
                                                     const PipelineSettings& pipeline, const Scene& scene,
                                                     const std::vector<Pose>& first_poses);

/// The pipelines that this engine can build; a test checks that they are those of pipeline_table.
std::vector<PipelineKind> enginePipelines();

/// The name of the engine, for provenance: "Bullet 3.24, double precision".
std::string engineVersion();

/// The precision that this engine was built in.
Precision enginePrecision();

}  // namespace fissure
