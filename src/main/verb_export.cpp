#include <algorithm>
#include <iostream>
#include <list>
#include <memory>

#include "base/error.h"
#include "files/output_claim.h"
#include "main/exit_codes.h"
#include "main/verbs.h"
#include "paraview/paraview_export.h"
#include "process/apart.h"
#include "process/interrupt.h"
#include "store/result_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string result;
  std::vector<std::string> pipelines;
  std::string folder;
  bool force = false;
};

/// One run that is to be exported; `meshes` read from `reader`.
struct ExportedRun {
  ExportedRun(const fs::path& result, std::string run_name)
      : name(std::move(run_name)), reader(result, name), meshes(movingMeshes(reader)) {}
  ExportedRun(const ExportedRun&) = delete;
  ExportedRun& operator=(const ExportedRun&) = delete;

  std::string name;
  RunReader reader;
  MovingMeshes meshes;
};

std::vector<std::string> chosenRuns(const ExportOptions& options, const ResultInfo& info) {
  std::vector<std::string> names;
  for (const PipelineResult& run : info.pipelines) names.push_back(run.name);
  std::string known;
  for (const std::string& name : names) known.append(known.empty() ? "" : ", ").append(name);
  for (const std::string& wanted : options.pipelines)
    if (std::find(names.begin(), names.end(), wanted) == names.end())
      throw InputError(inFile(options.result), "has no run \"" + wanted + "\", expected one of " + known);
  if (options.pipelines.empty()) return names;
  std::vector<std::string> chosen;
  for (const std::string& wanted : options.pipelines)
    if (std::find(chosen.begin(), chosen.end(), wanted) == chosen.end()) chosen.push_back(wanted);
  return chosen;
}

/// Those that have snapshots; a run named on the command line must have some.
std::list<ExportedRun> openRuns(const ExportOptions& options) {
  const ResultInfo info = readResultInfo(options.result);
  if (!info.complete || info.reference)
    throw InputError(
        inFile(options.result),
        std::string(info.reference ? "a reference, with a few rows of each series" : "not complete") +
            ", expected a finished result");
  std::list<ExportedRun> runs;
  for (const std::string& name : chosenRuns(options, info)) {
    if (!runs.emplace_back(options.result, name).meshes.times_s.empty()) continue;
    if (!options.pipelines.empty())
      throw InputError(
          inFile(options.result),
          "run " + name + " has no snapshots, expected some (record: {snapshots_every_s: 0.01})");
    runs.pop_back();
  }
  if (runs.empty())
    throw InputError(inFile(options.result),
                     "has no snapshots, expected some (record: {snapshots_every_s: 0.01})");
  return runs;
}

/// Reads every value that is exported once, apart: what is damaged deep inside is found before anything is
/// written.
void tryRuns(const ExportOptions& options) {
  tryReading(options.result, [&] {
    for (const ExportedRun& run : openRuns(options))
      for (std::size_t snapshot = 0; snapshot < run.meshes.times_s.size(); ++snapshot)
        for (const MovingMesh& mesh : run.meshes.meshes) {
          mesh.positions_m.values(snapshot);
          for (const PointArray& array : mesh.arrays) array.values(snapshot);
        }
  });
}

int exportResult(const ExportOptions& options) {
  tryRuns(options);
  const std::list<ExportedRun> runs = openRuns(options);
  const fs::path folder = options.folder.empty() ? fs::path(options.result).replace_extension(".paraview")
                                                 : fs::path(options.folder);
  std::list<OutputClaim> claims;
  for (const ExportedRun& run : runs)
    for (const std::string& name : exportNames(run.name, run.meshes)) {
      refuseInput(options.result, folder / name);
      claims.emplace_back(folder / name, options.force);
    }
  Interrupt interrupt;  // a run is exported whole or not at all
  for (const ExportedRun& run : runs) {
    if (interrupt.requested()) {
      std::cerr << "interrupted: the runs that were exported are kept\n";
      return exit_interrupted;
    }
    exportRun(folder, run.name, run.meshes, options.force);
    std::cout << "ParaView: " << (folder / (run.name + ".xdmf")).string() << ", " << run.meshes.times_s.size()
              << " times\n";
  }
  return exit_good;
}

}  // namespace

Verb addExport(Command app) {
  const auto options = std::make_shared<ExportOptions>();
  Command command = app.command(
      "export", "snapshots of a result for ParaView: a .xdmf a run (any version), .vtkhdf files (5.12 on)");
  command.example("fissure export out/press.h5 --pipeline fukuhara");
  command.option("RESULT", options->result, "result file with snapshots").required().notEmpty();
  command.option("--pipeline", options->pipelines, "only this run (repeatable); default: all with snapshots")
      .repeated();
  command
      .option("-o,--output", options->folder, "folder for the files; default: <RESULT without .h5>.paraview")
      .notEmpty();
  command.flag("--force", options->force, "replace existing files");
  return {command, [options] { return exportResult(*options); }};
}

}  // namespace fissure
