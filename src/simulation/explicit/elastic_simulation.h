#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/scene.h"
#include "scenario/scenario.h"
#include "stepping/simulation.h"

namespace fissure {

/// Builds the world of one run whose body is elastic, with its tools at `first_poses`: explicit finite
/// elements in substeps, and in each of them the contacts of the pipeline, on tool poses between those of the
/// step (METHOD section 10). Tools that contacts push move by substeps too. The scene has one body, with a
/// volume; the pipeline has a contact method. What contacts report of a step is of its last substep, forces
/// are means over the step. Throws std::invalid_argument where the material or the scene is not valid.
std::unique_ptr<Simulation> makeElasticSimulation(const Scenario& scenario, const PipelineSettings& pipeline,
                                                  const Scene& scene, const std::vector<Pose>& first_poses);

/// What moves the tissue, for the record: "explicit finite elements, double precision".
std::string elasticEngineVersion();

}  // namespace fissure
