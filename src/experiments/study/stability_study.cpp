#include "study/stability_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.h"
#include "files/write_file.h"
#include "study/stability_result.h"
#include "study/study_sweep.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

fs::path aloneFolder(const StabilityPanel& panel) {
  return panel.folder.string() + "_alone";
}

/// The map's scenario without tools and laws, in the study's folder.
fs::path writeScenarioAlone(const StabilityPanel& panel) {
  fs::path file = panel.folder.parent_path() / "alone.yaml";
  const fs::path base = fs::weakly_canonical(fs::absolute(panel.scenario_file))
                            .lexically_relative(fs::weakly_canonical(fs::absolute(file.parent_path())));
  replaceFile(
      file,
      fmt::format(
          "# Made by fissure study.\nbase: {}\ntime: {{duration_s: 1}}\ntools: []\nforce: []\nexpect: []\n"
          "record: {{force_inputs: false}}\n",
          formatText(base.generic_string())));
  return file;
}

/// What a cell changes of its tissue.
std::vector<Override> withoutTool(const std::vector<Override>& overrides) {
  std::vector<Override> kept;
  for (const Override& change : overrides)
    if (!change.path.starts_with("tools") && !change.path.starts_with("force")) kept.push_back(change);
  return kept;
}

/// Whether it helps to know how the tissue fares without the tool.
bool asksForAlone(StabilityClass kind) {
  return kind >= StabilityClass::non_finite && kind <= StabilityClass::force_out_of_range &&
         kind != StabilityClass::unsound_alone;
}

CellRun cellRun(const StudyRun& run, const StabilityCell& cell, const std::string& pipeline) {
  CellRun read;
  if (!run.result.empty()) read = readCellRun(run.result, pipeline);
  read.status = run.status;
  read.step_s = cell.step_s;
  read.rest_from = cell.rest_from;
  read.thickness_m = cell.thickness_m;
  return read;
}

std::string sweepName(const StabilityPanel& panel, const char* ending) {
  std::string name = panel.map->name + "-" + panel.pipeline;
  name.resize(std::min<std::size_t>(name.size(), 57));
  return name + ending;
}

/// Removes the maps that `names` does not hold; an empty `names` keeps all. Throws InputError for an unknown
/// name.
void keepOnly(const std::vector<std::string>& names, std::vector<StabilityMap>& maps, const fs::path& file) {
  if (names.empty()) return;
  std::vector<std::string> known;
  for (const StabilityMap& map : maps) known.push_back(map.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(inFile(file), fmt::format("has no map \"{}\"{}", name, didYouMean(name, known)));
  std::erase_if(maps, [&](const StabilityMap& map) {
    return std::find(names.begin(), names.end(), map.name) == names.end();
  });
}

/// All combinations, the last axis fastest.
std::vector<std::vector<std::string>> gridOf(const StabilityMap& map) {
  std::vector<std::vector<std::string>> points{{}};
  for (const StabilityAxis& axis : map.axes) {
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& point : points)
      for (const std::string& value : axisValues(axis)) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    points = std::move(longer);
  }
  return points;
}

}  // namespace

StabilityStudy::StabilityStudy(const fs::path& file, const fs::path& folder,
                               const std::vector<std::string>& maps, const std::string& command_line)
    : settings_(loadStability(file)), folder_(folder), command_line_(command_line) {
  keepOnly(maps, settings_.maps, file);
  for (const StabilityMap& map : settings_.maps) {
    const fs::path base = settings_.baseOf(map);
    if (std::none_of(bases_.begin(), bases_.end(), [&](const Base& known) { return known.file == base; }))
      bases_.push_back({base, loadScenario(base)});
  }
  for (const StabilityMap& map : settings_.maps) addPanels(map);
}

const LoadedScenario& StabilityStudy::baseOf(const fs::path& file) const {
  return std::find_if(bases_.begin(), bases_.end(), [&](const Base& base) { return base.file == file; })
      ->loaded;
}

void StabilityStudy::addPanels(const StabilityMap& map) {
  const fs::path file = settings_.baseOf(map);
  std::vector<std::string> known;
  for (const PipelineSettings& entry : baseOf(file).scenario.pipelines) known.push_back(entry.name);
  for (const std::string& pipeline : map.pipelines.empty() ? known : map.pipelines) {
    if (std::find(known.begin(), known.end(), pipeline) == known.end())
      throw InputError(inFile(file), fmt::format("has no run \"{}\", which map {} names{}", pipeline,
                                                 map.name, didYouMean(pipeline, known)));
    panels_.push_back({&map, pipeline, file, folder_ / map.name / pipeline, false, {}, {}});
    panels_.back().whole_numbers = cellsOf(panels_.back()).lastAxisIsWhole();
    addCells(panels_.back(), gridOf(map), 0);
  }
}

StabilityCells StabilityStudy::cellsOf(const StabilityPanel& panel) const {
  return {baseOf(panel.scenario_file), panel.scenario_file, *panel.map, settings_.pressOf(*panel.map),
          panel.pipeline};
}

void StabilityStudy::addCells(StabilityPanel& panel, const std::vector<std::vector<std::string>>& points,
                              int round) const {
  const StabilityCells cells = cellsOf(panel);
  auto runnable = static_cast<std::size_t>(
      std::count_if(panel.cells.begin(), panel.cells.end(),
                    [](const StabilityPanel::Cell& cell) { return cell.cell.refused.empty(); }));
  for (const std::vector<std::string>& values : points) {
    StabilityPanel::Cell& cell = panel.cells.emplace_back();
    cell.cell = cells.cell(values);
    cell.round = round;
    if (cell.cell.refused.empty())
      cell.point = runnable++;
    else
      cell.classified = CellClass{StabilityClass::refused, cell.cell.refused};
  }
}

std::vector<fs::path> StabilityStudy::plan() {
  std::vector<fs::path> untried;
  for (StabilityPanel& panel : panels_) {
    std::vector<std::vector<Override>> points;
    for (const StabilityPanel::Cell& cell : panel.cells)
      if (cell.cell.refused.empty()) points.push_back(cell.cell.overrides);
    if (points.empty()) continue;
    putSweep({panel.folder, sweepName(panel, ""), panel.scenario_file, panel.pipeline,
              panel.map->time_s ? panel.map->time_s : settings_.limits.time_s, settings_.limits.memory_mib,
              std::move(points)});
    if (untriedIn(panel.folder) > 0) untried.push_back(panel.folder);
  }
  return untried;
}

std::size_t StabilityStudy::round(int slots, ProgressDisplay& display) {
  ++round_;
  for (const fs::path& folder : plan()) runUntried(folder, slots, command_line_, display);
  std::size_t added = 0;
  for (StabilityPanel& panel : panels_) {
    classifyCells(panel);
    if (settings_.alone) judgeAlone(panel, slots, display);
    added += refine(panel, round_);
  }
  return added;
}

void StabilityStudy::classifyCells(StabilityPanel& panel) const {
  if (std::all_of(panel.cells.begin(), panel.cells.end(),
                  [](const StabilityPanel::Cell& cell) { return cell.classified.has_value(); }))
    return;
  const std::vector<StudyRun> runs = runsOf(panel.folder);
  for (StabilityPanel::Cell& cell : panel.cells) {
    if (cell.classified || runs[cell.point].status.end == RunEnd::missing) continue;
    const StudyRun& run = runs[cell.point];
    cell.classified = classify(cellRun(run, cell.cell, panel.pipeline), settings_.criteria);
    cell.result = run.result;
    cell.wall_s = run.wall_s;
  }
}

/// Runs the tissue of cells that are not stable without the tool, and classifies them again.
void StabilityStudy::judgeAlone(StabilityPanel& panel, int slots, ProgressDisplay& display) const {
  std::map<std::string, std::size_t> places;  // of points, by their values
  std::vector<std::vector<Override>> points;
  std::vector<std::pair<StabilityPanel::Cell*, std::size_t>> asking;
  for (StabilityPanel::Cell& cell : panel.cells) {
    if (!cell.classified || !(cell.judged_alone || asksForAlone(cell.classified->kind))) continue;
    std::string values;
    std::vector<Override> point = withoutTool(cell.cell.overrides);
    for (const Override& change : point) values += change.path + "=" + change.value + "\n";
    const auto [place, is_new] = places.try_emplace(values, points.size());
    if (is_new) points.push_back(std::move(point));
    if (!cell.judged_alone) asking.emplace_back(&cell, place->second);
  }
  if (asking.empty()) return;
  putSweep({aloneFolder(panel), sweepName(panel, "_alone"), writeScenarioAlone(panel), panel.pipeline,
            panel.map->time_s ? panel.map->time_s : settings_.limits.time_s, settings_.limits.memory_mib,
            std::move(points)});
  runUntried(aloneFolder(panel), slots, command_line_, display);
  const std::vector<StudyRun> alone = runsOf(aloneFolder(panel)), runs = runsOf(panel.folder);
  for (const auto& [cell, place] : asking) {
    CellRun run = cellRun(runs[cell->point], cell->cell, panel.pipeline);
    run.alone = problemAlone(cellRun(alone[place], cell->cell, panel.pipeline), settings_.criteria);
    cell->classified = classify(run, settings_.criteria);
    cell->judged_alone = true;
  }
}

/// Whether the scenario takes these values; what multiplies whole numbers need not be one between two that
/// do.
bool StabilityStudy::isCell(const StabilityPanel& panel, const std::vector<std::string>& values) const {
  if (panel.map->axes.back().multiplies.empty()) return true;
  try {
    cellsOf(panel).cell(values);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Adds the cells between neighbours of different classes; their number.
std::size_t StabilityStudy::refine(StabilityPanel& panel, int round) const {
  if (panel.map->axes.back().values) return 0;
  std::vector<ClassedPoint> points;
  for (const StabilityPanel::Cell& cell : panel.cells) {
    if (!cell.classified) continue;
    std::vector<std::string> others = cell.cell.values;
    others.pop_back();
    points.push_back({std::move(others), *toReal(cell.cell.values.back()), cell.classified->kind});
  }
  panel.boundaries = boundariesOf(std::move(points));
  std::vector<std::vector<std::string>> wanted;
  for (const StabilityBoundary& boundary : panel.boundaries) {
    const std::optional<double> place = nextPlace(boundary, settings_.refine_to, panel.whole_numbers);
    if (!place) continue;
    std::vector<std::string> values = boundary.others;
    values.push_back(formatReal(*place));
    if (isCell(panel, values)) wanted.push_back(std::move(values));
  }
  addCells(panel, wanted, round);
  return wanted.size();
}

}  // namespace fissure
