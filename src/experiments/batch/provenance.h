#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "scenario/load.h"
#include "store/result_file.h"

namespace fissure {

/// The command line as a result file records it: words quoted where a shell needs it, and of absolute paths
/// only the file name, so that no machine's folders are published with a result.
std::string commandLine(int argc, const char* const* argv);

/// When a batch of runs was made.
struct RunTimes {
  std::chrono::system_clock::time_point started;
  std::chrono::system_clock::time_point ended;
  double wall_s = 0;
};

/// Everything about program, machine and input that may explain a result; no user and no host name.
Provenance collectProvenance(const LoadedScenario& loaded, const std::string& input_hashes,
                             const std::string& command_line, const RunTimes& times);

/// The same for a result salvaged from a part, about the salvaging program: what the front knew of the run
/// itself has died with it.
Provenance salvageProvenance(const LoadedScenario& loaded, const std::string& command_line);

/// "fnv1a64:..." of what a file holds; nothing when it cannot be read.
std::optional<std::string> fileHash(const std::filesystem::path& file);

/// "name=hash, name=hash" of the files a scenario was read from, as they are now: names relative to the
/// scenario's folder, or the file name alone outside it. Throws RunError when one cannot be read.
std::string inputHashes(const LoadedScenario& loaded);

}  // namespace fissure
