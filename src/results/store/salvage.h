#pragma once

#include <filesystem>
#include <string>

#include "base/run_status.h"

namespace fissure {

/// The run in a part file.
struct PartContent {
  std::string pipeline;  ///< name of the scenario's entry
  std::string scenario_resolved;
  RunStatus status;  ///< status that the worker wrote, or `salvaged` with the last step that is there
};

/// Inspects the part of a run that may never have been finished, up to the last flush to disk. Throws
/// InputError when the file is missing, no part, damaged, or has no row yet.
PartContent inspectPart(const std::filesystem::path& path);

}  // namespace fissure
