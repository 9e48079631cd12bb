#pragma once

#include <memory>
#include <vector>

#include "base/probe.h"
#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

/// The probes that this run needs, in the order of their series in the record. The same code for every
/// pipeline: whether it has tool nodes is in the scene, and nothing else may differ.
std::vector<std::unique_ptr<Probe>> makeProbes(const Scenario& scenario, const Scene& scene);

}  // namespace fissure
