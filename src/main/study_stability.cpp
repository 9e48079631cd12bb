#include "main/study_stability.h"

#include <unistd.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "main/exit_codes.h"
#include "main/result_json.h"
#include "study/stability_output.h"
#include "study/stability_study.h"

namespace fissure {

namespace {

struct StabilityOptions {
  std::string study;
  std::string folder;
  std::vector<std::string> maps;
  int slots = 1;
  bool plan = false;
  bool json = false;
  std::string command_line;
};

void printClasses(const StabilityStudy& study) {
  for (const auto& [kind, count] : countClasses(study)) {
    const CatalogEntry& entry = stabilityClasses()[static_cast<std::size_t>(kind)];
    std::cout << "  " << entry.name << ": " << counted(count, "cell") << " (" << entry.description << ")\n";
  }
}

/// Plans as far as the classes are known, and names the sweeps that are to be run before it can go on.
int planStability(StabilityStudy& study, int slots, ProgressDisplay& display) {
  while (true) {
    const std::vector<std::filesystem::path> folders = study.plan();
    for (const std::filesystem::path& folder : folders)
      std::cout << "fissure sweep " << folder.string() << "\n";
    if (!folders.empty()) return exit_good;
    if (study.round(slots, display) > 0) continue;
    writeStability(study);
    std::cout << "nothing is left to run\n";
    return exit_good;
  }
}

int runStability(const StabilityOptions& options) {
  const std::filesystem::path folder = options.folder.empty()
                                           ? std::filesystem::path("out") / loadStability(options.study).name
                                           : std::filesystem::path(options.folder);
  StabilityStudy study(options.study, folder, options.maps, options.command_line);
  ProgressDisplay display(std::cerr, STDERR_FILENO);
  if (options.plan) return planStability(study, options.slots, display);
  std::size_t wanted = 1;
  for (int round = 1; wanted > 0; ++round) {
    wanted = study.round(options.slots, display);
    writeStability(study);
    display.clear();
    std::cerr << "round " << round << ": " << counted(wanted, "more cell") << " on boundaries\n";
  }
  if (options.json) {
    nlohmann::ordered_json classes;
    for (const auto& [kind, count] : countClasses(study))
      classes[std::string(stabilityClasses()[static_cast<std::size_t>(kind)].name)] = count;
    std::cout << jsonText({{"exit_code", exit_good}, {"classes", classes}, {"folder", folder.string()}});
    return exit_good;
  }
  printClasses(study);
  std::cout << "maps: " << (folder / "study.json").string() << "\n";
  return exit_good;
}

}  // namespace

Verb addStability(Command study, const std::string& command_line) {
  const auto options = std::make_shared<StabilityOptions>();
  options->command_line = command_line;
  Command command = study.command("stability", "where runs break: maps of classes, with their boundaries");
  command.example("fissure study stability configs/studies/stability_quick.yaml -j 2");
  command.option("study", options->study, "study file").required().notEmpty();
  command.option("-o,--output", options->folder, "folder of the study; default: out/<the name in the file>")
      .notEmpty();
  command.option("-j,--jobs", options->slots, "simulations side by side; default: 1").between(1, 1024);
  command
      .option("--map", options->maps,
              "this map alone (repeatable); the folder's tables, but not typical/, hold no others then. "
              "Default: all")
      .repeated()
      .notEmpty();
  command.flag("--plan", options->plan,
               "write the sweeps of the next cells and name those to run, for a cluster");
  command.flag("--json", options->json, "how many cells have which class, for machines, on standard output");
  return {command, [=] { return runStability(*options); }};
}

}  // namespace fissure
