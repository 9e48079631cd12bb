#pragma once

#include <filesystem>
#include <string>

#include "process/worker.h"
#include "scenario/pipelines.h"

namespace fissure {

/// Path of the worker program for this precision ("f64", "f32"): in the folder $FISSURE_ENGINE_DIR where that
/// is set, else beside this program. Throws RunError when it does not exist.
std::filesystem::path engineProgram(const std::string& precision);

/// The arguments of the worker of one run.
struct EngineRun {
  std::filesystem::path scenario;   ///< file with the resolved scenario
  std::filesystem::path directory;  ///< folder of the scenario's relative file names
  const PipelineSettings& pipeline;
  std::filesystem::path part;  ///< part file that it writes
};

/// The task that runs the worker. Throws RunError as engineProgram().
WorkerTask engineTask(const EngineRun& run);

}  // namespace fissure
