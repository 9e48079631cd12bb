#pragma once

#include "scenario/scenario.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// The scenario that a composed document says, with names filled in where they may be left out; values are
/// not checked. Throws InputError with the origin of the first thing that is unknown, missing or of the wrong
/// type.
Scenario readScenario(const YamlNode& root);

}  // namespace fissure
