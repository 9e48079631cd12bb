#pragma once

#include <memory>
#include <vector>

#include "base/probe.h"
#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

/// The probes that a run needs, in the order of their series in the record. They do not depend on the
/// pipeline, except on whether the scene has tool nodes.
std::vector<std::unique_ptr<Probe>> makeProbes(const Scenario& scenario, const Scene& scene);

}  // namespace fissure
