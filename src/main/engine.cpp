// The worker: one scenario through one pipeline into one part file.
//   exit 0: the part is finished (its status says ok or non_finite); 2: bad input; 3: failed
#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "base/error.h"
#include "engine/simulation.h"
#include "measure/probes.h"
#include "render/offscreen_renderer.h"
#include "run/run.h"
#include "scenario/load.h"
#include "store/part_file.h"

namespace {

using namespace fissure;

const PipelineSettings& findPipeline(const Scenario& scenario, const std::string& name) {
  for (const PipelineSettings& pipeline : scenario.pipelines) {
    if (pipeline.name == name) return pipeline;
  }
  throw InputError("the scenario has no pipeline entry named '" + name + "'");
}

/// Tells the front how far the run is, at most ten times a second.
class ProgressLines {
 public:
  void operator()(std::int64_t step, std::int64_t steps) {
    const auto now = std::chrono::steady_clock::now();
    if (step < steps && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    std::cout << "progress " << step << ' ' << steps << std::endl;
  }

 private:
  std::chrono::steady_clock::time_point last_{};
};

void work(const std::string& file, const std::string& directory, const std::string& name,
          const std::string& part) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot be read");
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  // As if the file stood where the user's did, so that relative names mean the same.
  const LoadedScenario loaded =
      parseScenario(text, std::filesystem::path(directory) / std::filesystem::path(file).filename());
  const Scenario& scenario = loaded.scenario;
  const PipelineSettings& pipeline = findPipeline(scenario, name);
  if (pipeline.precision != enginePrecision())
    throw InputError("the entry '" + name + "' wants precision " + pipeline.precision + ", this worker is " +
                     enginePrecision());
  Run run(scenario, pipeline);
  auto probes = makeProbes(scenario, run.scene());
  const RecordLayout layout = Run::declareLayout(probes);
  const auto sink = createPartFile(part, {.scenario = scenario,
                                          .pipeline = pipeline,
                                          .scene = run.scene(),
                                          .layout = layout,
                                          .expected_rows = static_cast<std::size_t>(run.stepCount() + 1),
                                          .scenario_resolved = loaded.resolved});
  const auto renderer = [&](const State& first) {
    return makeOffscreenRenderer(run.scene(), *scenario.record.frames, first);
  };
  run.execute({.sink = *sink,
               .probes = probes,
               .layout = layout,
               .make_frame_source = renderer,
               .progress = ProgressLines()});
}

int parseAndWork(int argc, const char* const* argv) {
  CLI::App app("fissure's worker: one scenario through one pipeline into one part file (started by fissure)");
  std::string scenario, directory, pipeline, part;
  app.add_option("--scenario", scenario, "scenario file, resolved")->required();
  app.add_option("--directory", directory, "where the scenario's relative file names start")->required();
  app.add_option("--pipeline", pipeline, "name of the pipeline entry to run")->required();
  app.add_option("--part", part, "part file to write")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  work(scenario, directory, pipeline, part);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parseAndWork(argc, argv);
  } catch (const InputError& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 3;
  }
}
