#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "batch/batch.h"
#include "check/scenario_warnings.h"
#include "main/exit_codes.h"
#include "main/result_json.h"
#include "main/result_table.h"
#include "main/scenario_options.h"
#include "main/verbs.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

struct RunOptions {
  ScenarioOptions scenarios;
  std::string output;
  OutputRules rules;
  bool json = false;
  int slots = 1;
};

fs::path outputOf(const RunOptions& options, const CheckedScenario& checked) {
  if (!options.output.empty()) return options.output;
  return fs::path("out") / (checked.loaded.scenario.name + ".h5");
}

/// All scenarios are checked before the first file is made, and all files can be written before the first run
/// starts. Warnings come last: what is refused is one line.
std::vector<Experiment> prepare(const RunOptions& options) {
  if (!options.output.empty() && options.scenarios.files.size() > 1)
    throw InputError("-o " + options.output +
                     ": names one file for several scenarios, expected one scenario");
  std::vector<CheckedScenario> checked;
  std::vector<std::string> warnings;
  for (const std::string& file : options.scenarios.files) {
    checked.push_back(checkScenario(file, options.scenarios.selection()));
    for (const std::string& warning : scenarioWarnings(checked.back()))
      warnings.push_back(std::string(file).append(": ").append(warning));
    checked.back().prepared = {};  // workers build their own
  }
  for (std::size_t i = 0; i < checked.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (outputOf(options, checked[i]) == outputOf(options, checked[j]))
        throw InputError(inFile(checked[i].file), "is named as " + checked[j].file.string() +
                                                      " is, both would write " +
                                                      outputOf(options, checked[i]).string());
  std::vector<Experiment> experiments;
  experiments.reserve(checked.size());
  for (CheckedScenario& scenario : checked) {
    const fs::path output = outputOf(options, scenario);
    experiments.emplace_back(std::move(scenario), output, options.rules);
  }
  for (const std::string& warning : warnings) std::cerr << warning << "\n";
  return experiments;
}

void printExpectations(const std::vector<CheckedExpectation>& expectations) {
  if (expectations.empty()) return;
  std::size_t held = 0;
  for (const CheckedExpectation& checked : expectations) {
    if (checked.holds)
      ++held;
    else
      std::cout << "expectation failed: " << expectationText(checked) << "\n";
  }
  std::cout << "expectations: " << held << " of " << expectations.size() << " hold\n";
}

void addJson(const Experiment& experiment, nlohmann::ordered_json& list) {
  for (const CheckedExpectation& checked : experiment.expectations())
    list.push_back({{"scenario", experiment.checked().loaded.scenario.name},
                    {"run", checked.run},
                    {"quantity", checked.quantity},
                    {"found", checked.found},
                    {"expected", checked.expected},
                    {"holds", checked.holds}});
}

void printText(const std::vector<Experiment>& experiments) {
  for (const Experiment& experiment : experiments) {
    const std::string& name = experiment.checked().loaded.scenario.name;
    for (const fs::path& part : experiment.keptParts())
      std::cout << "part: " << part.string() << " (for fissure salvage)\n";
    for (const std::string& run : experiment.unkeptParts()) std::cout << "no part kept of " << run << "\n";
    if (!experiment.error().empty()) {
      std::cerr << experiment.error() << "\n";
      continue;
    }
    if (!experiment.info()) {
      std::cout << name << ": interrupted before a run was finished, no result\n";
      continue;
    }
    if (experiments.size() > 1) std::cout << name << "\n";
    std::cout << resultTable(experiment.info()->pipelines);
    printExpectations(experiment.expectations());
    std::cout << "result: " << experiment.output().string() << "\n";
  }
}

void printJson(const std::vector<Experiment>& experiments, int code) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  nlohmann::ordered_json expectations = nlohmann::ordered_json::array();
  for (const Experiment& experiment : experiments) {
    if (experiment.info()) results.push_back(resultJson(experiment.output(), *experiment.info()));
    addJson(experiment, expectations);
    for (const fs::path& part : experiment.keptParts()) parts.push_back(part.string());
  }
  std::cout << jsonText(
      {{"exit_code", code}, {"results", results}, {"expectations", expectations}, {"kept_parts", parts}});
}

int exitCode(BatchOutcome outcome) {
  switch (outcome) {
    case BatchOutcome::good:
      return exit_good;
    case BatchOutcome::unexpected:
      return exit_differs;
    case BatchOutcome::failed:
      return exit_run_failed;
    case BatchOutcome::interrupted:
      return exit_interrupted;
  }
  throw std::logic_error("no such outcome of a batch");
}

int runScenarios(const RunOptions& options, const std::string& command_line) {
  Interrupt interrupt;  // before the first file is made, so that none is left behind
  std::vector<Experiment> experiments = prepare(options);
  ProgressDisplay display(std::cerr, STDERR_FILENO);
  Batch batch(experiments, command_line, display);
  batch.run(options.slots, interrupt);
  const int code = exitCode(batch.outcome());
  if (options.json)
    printJson(experiments, code);
  else
    printText(experiments);
  return code;
}

}  // namespace

Verb addRun(Command app, const std::string& command_line) {
  const auto options = std::make_shared<RunOptions>();
  Command command = app.command("run", "simulate scenarios and write one result file for each");
  command.example("fissure run press.yaml -j 2 --set tools.spatula.motion.segments.0.speed_m_s=0.2");
  addScenarioOptions(command, options->scenarios);
  command.option("-o,--output", options->output, "result file; default: out/<scenario's name>.h5").notEmpty();
  command.flag("--force", options->rules.replace, "replace an existing result");
  command.flag("--keep-parts", options->rules.keep_parts,
               "keep what unfinished runs have written, as <result>.<run>.part, for salvage");
  command.option("-j,--jobs", options->slots, "runs side by side; more than one disturbs the measured times")
      .between(1, 1024)
      .showDefault();
  command.flag("--json", options->json, "the table for machines, on standard output");
  return {command, [options, command_line] { return runScenarios(*options, command_line); }};
}

}  // namespace fissure
