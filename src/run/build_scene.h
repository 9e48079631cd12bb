#pragma once

#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

/// The geometry that a scenario describes. Tools get their nodes only when `with_nodes`.
/// Throws InputError for a mesh file that cannot be read (loadSurface).
Scene buildScene(const Scenario& scenario, bool with_nodes);

}  // namespace fissure
