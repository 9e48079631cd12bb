#include "study/stability_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/write_file.h"
#include "scenario/compose.h"
#include "study/study_command.h"
#include "table/sweep_csv.h"
#include "text/scalars.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string nameOfClass(StabilityClass kind) {
  return std::string(stabilityClasses()[static_cast<std::size_t>(kind)].name);
}

std::string line(std::initializer_list<std::string> fields) {
  std::vector<std::string> texts;
  for (const std::string& field : fields) texts.push_back(csvField(field));
  return fmt::format("{}\n", fmt::join(texts, ","));
}

std::string axisPath(const StabilityPanel& panel, std::size_t axis) {
  return axis < panel.map->axes.size() ? panel.map->axes[axis].path : std::string();
}

/// What makes the cell of the base scenario. One that was too slow stops at the time that it had.
std::vector<Override> overridesOf(const StabilityStudy& study, const StabilityPanel& panel,
                                  const StabilityPanel::Cell& cell) {
  std::vector<Override> overrides = cell.cell.overrides;
  const std::optional<double> time_s = panel.map->time_s ? panel.map->time_s : study.settings().limits.time_s;
  if (time_s && cell.classified && cell.classified->kind == StabilityClass::too_slow)
    overrides.push_back({fmt::format("pipelines.{}.time_limit_s", panel.pipeline), formatReal(*time_s)});
  return overrides;
}

/// The command that repeats a cell's run into a result of its own, for a shell.
std::string commandOf(const StabilityStudy& study, const StabilityPanel& panel,
                      const StabilityPanel::Cell& cell) {
  return runCommand(panel.scenario_file, panel.pipeline, overridesOf(study, panel, cell));
}

std::string cellsText(const StabilityStudy& study) {
  std::string text = line({"map", "pipeline", "axis_1", "value_1", "axis_2", "value_2", "class",
                           "frequency_Hz", "reason", "round", "wall_s", "result", "command"});
  for (const StabilityPanel& panel : study.panels()) {
    for (const StabilityPanel::Cell& cell : panel.cells) {
      const CellClass found = cell.classified.value_or(CellClass());
      const std::string value_2 = cell.cell.values.size() > 1 ? cell.cell.values[1] : std::string();
      const std::string result =
          cell.result.empty() ? "" : cell.result.lexically_relative(study.folder()).generic_string();
      text += line({panel.map->name, panel.pipeline, axisPath(panel, 0), cell.cell.values[0],
                    axisPath(panel, 1), value_2, cell.classified ? nameOfClass(found.kind) : "",
                    found.frequency_Hz > 0 ? formatReal(found.frequency_Hz) : "", found.reason,
                    std::to_string(cell.round), fmt::format("{:.3f}", cell.wall_s), result,
                    commandOf(study, panel, cell)});
    }
  }
  return text;
}

std::string boundariesText(const StabilityStudy& study) {
  std::string text = line({"map", "pipeline", "other_axis", "other_value", "axis", "below", "above",
                           "class_below", "class_above"});
  for (const StabilityPanel& panel : study.panels()) {
    const std::size_t last = panel.map->axes.size() - 1;
    for (const StabilityBoundary& b : panel.boundaries)
      text += line({panel.map->name, panel.pipeline, last > 0 ? axisPath(panel, 0) : "",
                    b.others.empty() ? "" : b.others[0], axisPath(panel, last), formatReal(b.below),
                    formatReal(b.above), nameOfClass(b.class_below), nameOfClass(b.class_above)});
  }
  return text;
}

ordered_json cellJson(const StabilityStudy& study, const StabilityPanel& panel,
                      const StabilityPanel::Cell& cell) {
  ordered_json json = {{"values", cell.cell.values}, {"round", cell.round}, {"wall_s", cell.wall_s}};
  json["class"] = cell.classified ? ordered_json(nameOfClass(cell.classified->kind)) : ordered_json();
  if (cell.classified) json["reason"] = cell.classified->reason;
  if (cell.classified && cell.classified->frequency_Hz > 0)
    json["frequency_Hz"] = cell.classified->frequency_Hz;
  if (!cell.result.empty()) json["result"] = cell.result.lexically_relative(study.folder()).generic_string();
  json["command"] = commandOf(study, panel, cell);
  return json;
}

ordered_json panelJson(const StabilityStudy& study, const StabilityPanel& panel) {
  ordered_json json = {
      {"map", panel.map->name}, {"description", panel.map->description}, {"pipeline", panel.pipeline}};
  for (const StabilityAxis& axis : panel.map->axes)
    json["axes"].push_back({{"path", axis.path},
                            {"multiplies", axis.multiplies},
                            {"scale", axis.values   ? "values"
                                      : axis.linear ? "linear"
                                                    : "logarithmic"},
                            {"grid", axisValues(axis)}});
  for (const StabilityPanel::Cell& cell : panel.cells) json["cells"].push_back(cellJson(study, panel, cell));
  json["boundaries"] = ordered_json::array();
  for (const StabilityBoundary& b : panel.boundaries)
    json["boundaries"].push_back({{"others", b.others},
                                  {"below", b.below},
                                  {"above", b.above},
                                  {"class_below", nameOfClass(b.class_below)},
                                  {"class_above", nameOfClass(b.class_above)}});
  return json;
}

std::string studyText(const StabilityStudy& study) {
  const StabilitySettings& settings = study.settings();
  const StabilityCriteria& c = settings.criteria;
  ordered_json json = {{"format", "fissure-stability"},
                       {"format_version", 1},
                       {"name", settings.name},
                       {"description", settings.description},
                       {"refine_to", settings.refine_to}};
  json["criteria"] = {{"depth_m", c.depth_m},
                      {"depth_of_thickness", c.depth_of_thickness},
                      {"proved", c.proved},
                      {"energy_growth", c.energy_growth},
                      {"chatter_share", c.chatter_share},
                      {"chatter_crossings", c.chatter_crossings},
                      {"force_N", c.force_N},
                      {"forces", c.forces}};
  for (const CatalogEntry& entry : stabilityClasses())
    json["classes"].push_back({{"name", entry.name}, {"means", entry.description}});
  for (const StabilityPanel& panel : study.panels()) json["panels"].push_back(panelJson(study, panel));
  return json.dump(1) + "\n";
}

/// Files of meshes and logs, as they are called from `folder`.
void moveFileNames(YamlNode& node, const fs::path& directory, const fs::path& folder) {
  for (YamlNode& child : node.children) {
    if (child.key == "file" && child.kind == YamlNode::Kind::scalar)
      child.text = fs::weakly_canonical(fs::absolute(directory / child.text))
                       .lexically_relative(fs::weakly_canonical(fs::absolute(folder)))
                       .generic_string();
    moveFileNames(child, directory, folder);
  }
}

std::string scenarioText(const StabilityStudy& study, const StabilityPanel& panel,
                         const StabilityPanel::Cell& cell, const fs::path& folder) {
  const LoadedScenario loaded = loadScenario(panel.scenario_file, overridesOf(study, panel, cell));
  YamlNode root = parseYaml(loaded.composed, inFile(panel.scenario_file, 1));
  std::erase_if(root.children, [](const YamlNode& child) { return child.key == "expect"; });
  if (YamlNode* entries = root.find("pipelines"))
    std::erase_if(entries->children, [&](const YamlNode& item) { return itemName(item) != panel.pipeline; });
  moveFileNames(root, loaded.scenario.directory, folder);
  std::string text = fmt::format("# {}: {}\n# map {}, pipeline {}", nameOfClass(cell.classified->kind),
                                 cell.classified->reason, panel.map->name, panel.pipeline);
  for (std::size_t a = 0; a < cell.cell.values.size(); ++a)
    text += fmt::format(", {}={}", panel.map->axes[a].path, cell.cell.values[a]);
  text += "\n";
  for (const YamlNode& child : root.children) text += child.key + ": " + flowText(child) + "\n";
  return text;
}

void writeTypical(const StabilityStudy& study) {
  using Place = std::pair<const StabilityPanel*, const StabilityPanel::Cell*>;
  std::map<StabilityClass, std::vector<Place>> cells;
  for (const StabilityPanel& panel : study.panels())
    for (const StabilityPanel::Cell& cell : panel.cells)
      if (cell.classified && cell.round == 0) cells[cell.classified->kind].emplace_back(&panel, &cell);
  const fs::path folder = study.folder() / "typical";
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw RunError(folder.string() + ": cannot be made: " + error.message());
  for (const auto& [kind, places] : cells) {
    const auto& [panel, cell] = places[places.size() / 2];
    replaceFile(folder / (nameOfClass(kind) + ".yaml"), scenarioText(study, *panel, *cell, folder));
  }
}

}  // namespace

std::map<StabilityClass, std::size_t> countClasses(const StabilityStudy& study) {
  std::map<StabilityClass, std::size_t> counts;
  for (const StabilityPanel& panel : study.panels())
    for (const StabilityPanel::Cell& cell : panel.cells)
      if (cell.classified) ++counts[cell.classified->kind];
  return counts;
}

void writeStability(const StabilityStudy& study) {
  replaceFile(study.folder() / "cells.csv", cellsText(study));
  replaceFile(study.folder() / "boundaries.csv", boundariesText(study));
  replaceFile(study.folder() / "study.json", studyText(study));
  writeTypical(study);
}

}  // namespace fissure
