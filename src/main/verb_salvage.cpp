#include <algorithm>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "batch/assemble_apart.h"
#include "batch/provenance.h"
#include "files/output_claim.h"
#include "main/exit_codes.h"
#include "main/result_table.h"
#include "main/verbs.h"
#include "process/apart.h"
#include "store/salvage.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

struct SalvageOptions {
  std::string part;
  std::string output;
  bool force = false;
};

/// The scenario of a part, cut down to the run that it is of.
LoadedScenario scenarioOf(const PartContent& content, const std::string& part) {
  LoadedScenario loaded = parseStoredScenario(content.scenario_resolved, part);
  std::erase_if(loaded.scenario.pipelines,
                [&](const PipelineSettings& entry) { return entry.name != content.pipeline; });
  if (loaded.scenario.pipelines.empty())
    throw InputError(inFile(part), "its scenario has no pipeline entry \"" + content.pipeline + "\"");
  return loaded;
}

fs::path outputOf(const SalvageOptions& options, const LoadedScenario& loaded) {
  if (!options.output.empty()) return options.output;
  const Scenario& scenario = loaded.scenario;
  return fs::path("out") / (scenario.name + "." + scenario.pipelines.front().name + ".salvaged.h5");
}

int salvage(const SalvageOptions& options, const std::string& command_line) {
  tryReading(options.part, [&] { inspectPart(options.part); });
  const PartContent content = inspectPart(options.part);
  const LoadedScenario loaded = scenarioOf(content, options.part);
  const fs::path output = outputOf(options, loaded);
  std::error_code missing;
  if (fs::equivalent(options.part, output, missing))
    throw InputError(inFile(output), "is the part itself, expected another name for the result");
  const OutputClaim claim(output, options.force);
  salvageApart(output, loaded, salvageProvenance(loaded, command_line),
               {loaded.scenario.pipelines.front(), options.part, content.status});
  std::cout << resultTable(readResultInfo(output).pipelines) << "result: " << output.string() << "\n";
  return exit_good;
}

}  // namespace

Verb addSalvage(Command app, const std::string& command_line) {
  const auto options = std::make_shared<SalvageOptions>();
  Command command =
      app.command("salvage", "make a result of what a run that was killed had brought to the disk");
  command.example("fissure salvage out/press.h5.fukuhara.part");
  command
      .option("PART", options->part,
              "part file: <result>.<run>.part, or .<result>.*/*.part after the death of fissure itself")
      .required()
      .notEmpty();
  command
      .option("-o,--output", options->output, "result file; default: out/<scenario's name>.<run>.salvaged.h5")
      .notEmpty();
  command.flag("--force", options->force, "replace an existing result");
  return {command, [options, command_line] { return salvage(*options, command_line); }};
}

}  // namespace fissure
