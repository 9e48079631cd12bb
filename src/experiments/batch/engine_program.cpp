#include "batch/engine_program.h"

#include <unistd.h>

#include <cstdlib>

#include "base/error.h"
#include "scenario/catalog.h"

namespace fissure {

std::filesystem::path engineProgram(const std::string& precision) {
  namespace fs = std::filesystem;
  const char* chosen = std::getenv("FISSURE_ENGINE_DIR");
  const fs::path folder =
      chosen && *chosen ? fs::path(chosen) : fs::read_symlink("/proc/self/exe").parent_path();
  const std::string name = "fissure-engine-" + precision;
  if (::access((folder / name).c_str(), X_OK) != 0)
    throw RunError(name + ": no such program beside fissure; FISSURE_ENGINE_DIR names another folder");
  return folder / name;
}

WorkerTask engineTask(const EngineRun& run) {
  return {engineProgram(nameIn(catalog().precisions, run.pipeline.precision)),
          {"--scenario", run.scenario.string(), "--directory", run.directory.string(), "--pipeline",
           run.pipeline.name, "--part", run.part.string()},
          run.pipeline.time_limit_s,
          0,
          run.part.parent_path()};
}

}  // namespace fissure
