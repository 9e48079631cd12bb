#pragma once

#include <memory>
#include <vector>

#include "base/probe.h"
#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

/// The probes that this run needs, in the order of their series in the record. The same code for every
/// pipeline.
std::vector<std::unique_ptr<Probe>> makeProbes(const Scenario& scenario, const PipelineSettings& pipeline,
                                               const Scene& scene);

}  // namespace fissure
