#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "main/exit_codes.h"
#include "main/result_json.h"
#include "main/result_table.h"
#include "main/sweep_info.h"
#include "main/verbs.h"
#include "process/apart.h"

namespace fissure {

namespace {

struct InfoOptions {
  std::string file;
  bool json = false;
};

std::string shapeText(const std::vector<unsigned long long>& shape) {
  std::string text;
  for (const unsigned long long size : shape) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text.empty() ? "scalar" : text;
}

void printText(const ResultInfo& info) {
  std::cout << info.title << "\n"
            << info.format << ", version " << info.format_version << (info.complete ? "" : ", not complete")
            << (info.reference ? ", a reference: a few rows of each series" : "")
            << (info.salvaged ? ", salvaged from a run that did not finish" : "") << "\n\n"
            << resultTable(info.pipelines) << "\n"
            << summaryTable(info.pipelines) << "\nprovenance\n";
  for (const auto& [name, value] : info.provenance)
    std::cout << "  " << std::left << std::setw(18) << name << value << "\n";
  std::cout << "\ndatasets\n";
  std::size_t width = 0;
  for (const DatasetInfo& dataset : info.datasets) width = std::max(width, dataset.path.size());
  for (const DatasetInfo& dataset : info.datasets) {
    std::cout << "  " << std::left << std::setw(static_cast<int>(width)) << dataset.path << "  "
              << std::setw(4) << dataset.type << "  " << shapeText(dataset.shape);
    std::cout << (dataset.units.empty() ? "" : "  " + dataset.units) << "\n";
  }
}

int showSweep(const InfoOptions& options) {
  const SweepTable table(options.file);
  if (options.json)
    std::cout << jsonText(sweepInfoJson(options.file, table));
  else
    std::cout << sweepInfoText(table);
  return exit_good;
}

/// All that is printed later.
void readAny(const std::string& file) {
  if (isSweepTable(file))
    sweepInfoText(SweepTable(file));
  else
    readResultInfo(file);
}

int showFile(const InfoOptions& options) {
  tryReading(options.file, [&] { readAny(options.file); });
  if (isSweepTable(options.file)) return showSweep(options);
  const ResultInfo info = readResultInfo(options.file);
  if (options.json)
    std::cout << jsonText(resultJson(options.file, info));
  else
    printText(info);
  return exit_good;
}

}  // namespace

Verb addInfo(Command app) {
  const auto options = std::make_shared<InfoOptions>();
  Command command =
      app.command("info", "what a result file or a sweep's table holds and where it comes from");
  command.example("fissure info out/press.h5");
  command.option("FILE", options->file, "result file, or sweep.h5").required();
  command.flag("--json", options->json, "the same for machines");
  return {command, [options] { return showFile(*options); }};
}

}  // namespace fissure
