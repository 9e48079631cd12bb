#pragma once

#include "scenario/scenario.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// Reads a scenario from a composed document and fills in optional names; values are not checked. Throws
/// InputError with the origin of the first key or value that is unknown, missing or of the wrong type.
Scenario readScenario(const YamlNode& root);

}  // namespace fissure
