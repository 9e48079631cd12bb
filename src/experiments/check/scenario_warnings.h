#pragma once

#include <string>
#include <vector>

#include "check/scenario_input.h"

namespace fissure {

/// What a scenario asks for and will not get, a line each, for its pipelines that use nodes: nodes too wide
/// apart for the tissue, and narrow rows on a blade that moves obliquely to its faces.
std::vector<std::string> scenarioWarnings(const CheckedScenario& checked);

}  // namespace fissure
