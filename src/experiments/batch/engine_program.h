#pragma once

#include <filesystem>
#include <string>

#include "process/worker.h"
#include "scenario/pipelines.h"

namespace fissure {

/// The worker program for an engine of this precision ("f64"): in $FISSURE_ENGINE_DIR when that is set, else
/// beside this program. Throws RunError when it is not there.
std::filesystem::path engineProgram(const std::string& precision);

/// What the worker of one run is given.
struct EngineRun {
  std::filesystem::path scenario;   ///< file with the resolved scenario
  std::filesystem::path directory;  ///< where the scenario's relative file names start
  const PipelineSettings& pipeline;
  std::filesystem::path part;  ///< the file it writes
};

WorkerTask engineTask(const EngineRun& run);

}  // namespace fissure
