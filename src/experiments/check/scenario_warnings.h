#pragma once

#include <string>
#include <vector>

#include "check/scenario_input.h"

namespace fissure {

/// All warnings about a scenario, one line each: those of plausibilityWarnings() and, for pipelines that use
/// nodes, nodes too far apart for the tissue and narrow rows on a blade that moves obliquely to its faces.
std::vector<std::string> scenarioWarnings(const CheckedScenario& checked);

}  // namespace fissure
