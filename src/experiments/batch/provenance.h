#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "scenario/load.h"
#include "store/result_file.h"

namespace fissure {

/// The command line in the form that result files record: words are quoted where a shell needs it, and
/// absolute paths are reduced to the file name, so that no folders of a machine are published.
std::string commandLine(int argc, const char* const* argv);

/// Start, end and wall time of a batch of runs.
struct RunTimes {
  std::chrono::system_clock::time_point started;
  std::chrono::system_clock::time_point ended;
  double wall_s = 0;
};

/// All data about program, machine and input that may explain a result, without names of user and host.
Provenance collectProvenance(const LoadedScenario& loaded, const std::string& input_hashes,
                             const std::string& command_line, const RunTimes& times);

/// The same for a result salvaged from a part. It describes the salvaging program, because what the original
/// program knew of the run is lost.
Provenance salvageProvenance(const LoadedScenario& loaded, const std::string& command_line);

/// The hash of a file's contents, "sha256:..."; no value when it cannot be read.
std::optional<std::string> fileHash(const std::filesystem::path& file);

/// Present hashes of the files from which a scenario was read, "name=hash, name=hash", with names relative to
/// the scenario's folder, or the bare file name outside of it. Throws RunError when a file cannot be read.
std::string inputHashes(const LoadedScenario& loaded);

}  // namespace fissure
