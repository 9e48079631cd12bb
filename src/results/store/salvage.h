#pragma once

#include <filesystem>
#include <string>

#include "base/run_status.h"

namespace fissure {

/// What a part file holds of its one run.
struct PartContent {
  std::string pipeline;  ///< name of the entry it is the run of
  std::string scenario_resolved;
  RunStatus status;  ///< as the worker left it, or `salvaged` and up to which step the run is there
};

/// Looks into the part of a run that may never have ended. What counts as there is what the last flush before
/// the end had brought to the disk. Throws InputError when the file is missing, no part, damaged, or holds no
/// row yet.
PartContent inspectPart(const std::filesystem::path& path);

}  // namespace fissure
