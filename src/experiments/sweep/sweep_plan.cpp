#include "sweep/sweep_plan.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "base/error.h"
#include "base/hash.h"
#include "scenario/catalog.h"
#include "scenario/compose.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// The item of a list that `part` names or counts; the length when there is none.
template <class Item>
std::size_t itemAt(const std::vector<Item>& items, const std::string& part) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].name == part) return i;
  const std::optional<int> index = toInt(part);
  return index && *index >= 0 && static_cast<std::size_t>(*index) < items.size()
             ? static_cast<std::size_t>(*index)
             : items.size();
}

}  // namespace

YamlNode physicsOf(const SweepManifest& manifest, std::size_t entry) {
  YamlNode root = parseYaml(manifest.scenario, inFile(manifest.settings.name, 1));
  std::erase_if(root.children,
                [](const YamlNode& child) { return child.key == "expect" || child.key == "description"; });
  if (YamlNode* entries = root.find("pipelines"))
    std::erase_if(entries->children,
                  [&](const YamlNode& item) { return itemName(item) != manifest.pipelines[entry]; });
  return root;
}

SweepPlan::SweepPlan(SweepManifest manifest, const std::filesystem::path& folder)
    : manifest_(std::move(manifest)) {
  base_ = parseStoredScenario(manifest_.scenario, manifestFile(folder));
  base_.scenario.directory =
      (std::filesystem::weakly_canonical(folder) / manifest_.directory).lexically_normal();
  sortAxes();
  std::unordered_map<std::string, std::size_t> seen;
  for (const std::string& text : manifest_.points.texts()) {
    plain_.push_back(plainValue(text));
    text_ids_.push_back(seen.try_emplace(plain_.back(), plain_.size() - 1).first->second);
  }
  makeTasks();
  nameTasks();
}

/// Which axes move nothing, and which entries read each.
void SweepPlan::sortAxes() {
  const Scenario& scenario = base_.scenario;
  const std::vector<std::string>& paths = manifest_.points.paths();
  bool laws_move_nothing = std::none_of(
      scenario.tools.begin(), scenario.tools.end(),
      [](const ToolSettings& tool) { return tool.coupling && !tool.coupling->isPushedByContacts(); });
  // Laws that share a simulation see it by its rows: each step must have one.
  if (stepsPerRow(scenario.record, scenario.measure) > 1) laws_move_nothing = false;
  for (const std::string& path : paths) {
    if (path == "record.every" || path == "measure.every") laws_move_nothing = false;
    const std::vector<std::string> parts = splitPath(path);
    Axis& axis = axes_.emplace_back();
    if (parts[0] == "pipelines" && parts.size() > 2) {
      const std::size_t entry = itemAt(scenario.pipelines, parts[1]);
      if (entry < scenario.pipelines.size()) axis.only_entry = scenario.pipelines[entry].name;
    }
    if (parts[0] == "tools" && (parts.size() < 3 || parts[2] == "coupling")) laws_move_nothing = false;
    if (parts[0] != "force") continue;
    axis.law_index = parts.size() == 3 ? itemAt(scenario.force, parts[1]) : scenario.force.size();
    if (axis.law_index < scenario.force.size() &&
        entryOf(scenario.force[axis.law_index].model).find(parts[2])) {
      axis.law = true;
      axis.coefficient = parts[2];
    } else {
      laws_move_nothing = false;  // another model, say: then the coefficients may not be what they seem
    }
  }
  if (laws_move_nothing) return;
  for (Axis& axis : axes_) axis.law = false;
}

/// The values that matter at a point: those of law axes, or of the others that an entry reads.
std::string SweepPlan::key(std::size_t point, std::size_t entry, bool laws) const {
  std::string text;
  const SweepPoints& points = manifest_.points;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    if (axes_[a].law != laws || !reads(entry, a)) continue;
    text += std::to_string(text_ids_[points.indices()[point * axes_.size() + a]]) + ' ';
  }
  return text;
}

void SweepPlan::makeTasks() {
  struct Group {
    std::size_t first_task;  ///< one per repeat
    std::unordered_map<std::string, std::size_t> laws;
  };
  std::unordered_map<std::string, Group> groups;
  const std::size_t entries = manifest_.pipelines.size();
  const int repeats = manifest_.settings.repeats;
  run_sources_.reserve(manifest_.points.size() * entries * static_cast<std::size_t>(repeats));
  for (std::size_t point = 0; point < manifest_.points.size(); ++point) {
    for (std::size_t entry = 0; entry < entries; ++entry) {
      const std::string physics = std::to_string(entry) + ": " + key(point, entry, false);
      const auto [group, is_new] = groups.try_emplace(physics, Group{tasks_.size(), {}});
      for (int repeat = 0; is_new && repeat < repeats; ++repeat)
        tasks_.push_back({"", entry, repeat, point, {}});
      const auto [law, new_law] =
          group->second.laws.try_emplace(key(point, entry, true), group->second.laws.size());
      for (int repeat = 0; repeat < repeats; ++repeat) {
        const std::size_t task = group->second.first_task + static_cast<std::size_t>(repeat);
        if (new_law) tasks_[task].laws.push_back(point);
        run_sources_.push_back({task, law->second});
      }
    }
  }
}

/// What all tasks of an entry depend on: the scenario without what moves nothing and without other entries,
/// the files it names, the worker's way of keeping things.
std::string SweepPlan::commonText(std::size_t entry) const {
  std::string text =
      "fissure task 2\n" + flowText(physicsOf(manifest_, entry)) + "\n" + manifest_.pipelines[entry] + "\n";
  for (const auto& [file, hash] : manifest_.inputs)
    if (!manifest_.axis_inputs.contains(file)) text.append(file).append("=").append(hash).append("\n");
  if (const auto& curves = manifest_.settings.curves) {
    text += formatReal(curves->every_s) + " " + formatReal(curves->until_s.value_or(0));
    for (const std::string& quantity : curves->quantities) text += " " + quantity;
  }
  return text + "\n" + std::string(sweepKeeps()[static_cast<std::size_t>(manifest_.settings.keep)].name) +
         "\n";
}

/// The values of a point on law axes or on the others that an entry reads, a line each; with the files that
/// these name. Sorted: the order of a sweep file's axes changes nothing.
std::string SweepPlan::valueText(std::size_t point, std::size_t entry, bool laws) const {
  std::vector<std::string> lines;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    if (axes_[a].law != laws || !reads(entry, a)) continue;
    const std::string& value = plain_[manifest_.points.indices()[point * axes_.size() + a]];
    std::string& line = lines.emplace_back(manifest_.points.paths()[a] + "=" + value);
    for (const std::string& file : manifest_.axis_inputs)
      if (value.find(std::filesystem::path(file).filename().string()) != std::string::npos)
        line += " " + manifest_.inputs.at(file);
  }
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

void SweepPlan::nameTasks() {
  std::vector<std::string> common;
  for (std::size_t entry = 0; entry < manifest_.pipelines.size(); ++entry)
    common.push_back(fnv1a64(commonText(entry)));
  std::vector<std::vector<std::size_t>> moved(tasks_.size());  // of each task: where its sets of laws went
  for (std::size_t t = 0; t < tasks_.size(); ++t) {
    SweepTask& task = tasks_[t];
    std::vector<std::pair<std::string, std::size_t>> laws;
    for (std::size_t i = 0; i < task.laws.size(); ++i)
      laws.emplace_back(valueText(task.laws[i], task.entry, true), i);
    std::sort(laws.begin(), laws.end());
    const auto engine = manifest_.engines.find(precision(task));
    if (engine == manifest_.engines.end())
      throw InputError("no worker program of precision " + precision(task) + " in the plan of the sweep");
    std::string text = common[task.entry] + "\n" + engine->second + "\n" + std::to_string(task.repeat) +
                       "\n" + valueText(task.point, task.entry, false);
    const std::vector<std::size_t> points = task.laws;
    moved[t].resize(points.size());
    for (std::size_t i = 0; i < laws.size(); ++i) {
      text += "law\n" + laws[i].first;
      task.laws[i] = points[laws[i].second];
      moved[t][laws[i].second] = i;
    }
    task.id = fnv1a64(text);
  }
  for (RunSource& source : run_sources_) source.law = moved[source.task][source.law];
  rankTasks();
}

/// Shards get tasks in the order of their names: neighbours in a sweep cost alike, and an axis as long as
/// there are shards would give each shard one value of it.
void SweepPlan::rankTasks() {
  std::vector<std::size_t> order(tasks_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return tasks_[a].id < tasks_[b].id; });
  ranks_.resize(tasks_.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks_[order[i]] = i;
}

bool SweepPlan::reads(std::size_t entry, std::size_t axis) const {
  return axes_[axis].only_entry.empty() || axes_[axis].only_entry == manifest_.pipelines[entry];
}

PlannedRun SweepPlan::run(std::size_t index) const {
  const auto repeats = static_cast<std::size_t>(manifest_.settings.repeats);
  const std::size_t entries = manifest_.pipelines.size();
  const RunSource& source = run_sources_[index];
  return {index / (entries * repeats), index / repeats % entries, static_cast<int>(index % repeats),
          source.task, source.law};
}

std::vector<Override> SweepPlan::overrides(const SweepTask& task) const {
  std::vector<Override> overrides;
  for (std::size_t a = 0; a < axes_.size(); ++a)
    if (reads(task.entry, a) && !(axes_[a].law && task.laws.size() > 1))
      overrides.push_back({manifest_.points.paths()[a], manifest_.points.value(task.point, a)});
  return overrides;
}

std::vector<Override> SweepPlan::overridesAt(std::size_t point) const {
  std::vector<Override> overrides;
  for (std::size_t a = 0; a < axes_.size(); ++a)
    overrides.push_back({manifest_.points.paths()[a], manifest_.points.value(point, a)});
  return overrides;
}

std::vector<ForceSettings> SweepPlan::lawsAt(std::size_t point) const {
  std::vector<ForceSettings> laws = base_.scenario.force;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    if (!axes_[a].law) continue;
    const std::string& text = manifest_.points.value(point, a);
    const std::optional<double> number = toReal(text);
    if (!number) throw InputError(ofAxis(manifest_.points.paths()[a]), text + ", expected a number");
    ForceSettings& law = laws[axes_[a].law_index];
    law.coefficients.*entryOf(law.model).find(axes_[a].coefficient)->member = *number;
  }
  return laws;
}

const PipelineSettings& SweepPlan::entry(std::size_t index) const {
  const std::vector<PipelineSettings>& entries = base_.scenario.pipelines;
  const std::size_t at = itemAt(entries, manifest_.pipelines[index]);
  if (at == entries.size())
    throw InputError("no pipeline \"" + manifest_.pipelines[index] + "\" in the base scenario");
  return entries[at];
}

std::string SweepPlan::precision(const SweepTask& task) const {
  for (std::size_t a = 0; a < axes_.size(); ++a)
    if (axes_[a].only_entry == manifest_.pipelines[task.entry] &&
        manifest_.points.paths()[a].ends_with(".precision"))
      return manifest_.points.value(task.point, a);
  return nameIn(catalog().precisions, entry(task.entry).precision);
}

}  // namespace fissure
