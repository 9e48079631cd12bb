#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/catalog.h"

namespace fissure {

/// The templates of `fissure init`, with a description of one line each.
const std::vector<CatalogEntry>& templates();

/// Writes the scenario (or the sweep and its scenario) of template `kind` as `folder`/`name`.yaml, with the
/// files that it needs beside it, and returns the paths of all files. They can be run unchanged. Throws
/// InputError, before anything is written, where one of the files exists or the name is not valid, and
/// RunError when writing fails.
std::vector<std::filesystem::path> writeTemplate(const std::string& kind, const std::string& name,
                                                 const std::filesystem::path& folder);

}  // namespace fissure
