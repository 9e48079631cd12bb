#pragma once

#include <string>
#include <vector>

#include "keys/key_files.h"

namespace fissure {

/// The top-level keys of all kinds of files, one line each.
std::string topLevelText();

/// The full documentation of these keys, one block each; for a map also the keys in it, one line each.
std::string textOf(const std::vector<KeyPlace>& keys);

/// All keys as Markdown: configs/KEYS.md.
std::string keysAsMarkdown();

/// The allowed values of a key in words: "a list of 3, each a number above 0, in m".
std::string valueText(const KeyNode& node);

}  // namespace fissure
