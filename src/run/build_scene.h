#pragma once

#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

/// The geometry that a scenario describes. Tools get their nodes only when `with_nodes`.
Scene buildScene(const Scenario& scenario, bool with_nodes);

}  // namespace fissure
