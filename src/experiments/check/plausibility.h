#pragma once

#include <string>
#include <vector>

#include "check/scenario_input.h"

namespace fissure {

/// Warnings about settings of a scenario that can be simulated but are probably mistakes, one line each with
/// the key first: bodies and tools of more than 1 m or less than 0.1 mm, margins larger than the body, tools
/// that travel more than 1 m or start inside tissue, masses, moduli and coefficients of force laws left at
/// their defaults, laws of unbounded stiffness that push a coupled tool, bodies of too few triangles to bend,
/// and expectations of values that a run does not have.
std::vector<std::string> plausibilityWarnings(const CheckedScenario& checked);

}  // namespace fissure
