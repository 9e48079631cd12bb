#pragma once

#include <filesystem>
#include <string>

#include "study/stability_class.h"

namespace fissure {

/// What the criteria look at, from the result of a cell's run: summary and curves. The rest is the caller's.
/// Throws InputError as RunReader does.
CellRun readCellRun(const std::filesystem::path& file, const std::string& pipeline);

}  // namespace fissure
