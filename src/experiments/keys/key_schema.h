#pragma once

#include <string>

#include "scenario/key_tree.h"

namespace fissure {

/// The JSON Schema (draft 7) of one kind of file, for editors (yaml-language-server) and other programs.
/// Relations between keys are not in the schema, so a file that it accepts may still be wrong. A scenario
/// with a `base` may omit all other keys.
std::string schemaOf(const KeyNode& file);

}  // namespace fissure
