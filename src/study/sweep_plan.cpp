#include "study/sweep_plan.h"

#include <algorithm>
#include <unordered_map>

#include "base/error.h"
#include "base/hash.h"
#include "scenario/compose.h"
#include "scenario/scalars.h"

namespace fissure {

namespace {

std::vector<std::string> partsOf(const std::string& path) {
  std::vector<std::string> parts(1);
  for (const char c : path) {
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

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

double* coefficient(ForceSettings& law, const std::string& name) {
  if (name == "k") return &law.k;
  if (name == "lambda") return &law.lambda;
  if (name == "n") return &law.n;
  return name == "c" ? &law.c : nullptr;
}

/// Equal numbers in one way of writing.
std::string plainText(const std::string& text) {
  const ScalarKind kind = scalarKind(text);
  if (kind != ScalarKind::integer && kind != ScalarKind::real) return text;
  const std::optional<double> number = toReal(text);
  return number ? formatReal(*number) : text;
}

}  // namespace

SweepPlan::SweepPlan(SweepManifest manifest, const std::filesystem::path& folder)
    : manifest_(std::move(manifest)) {
  base_ = parseStoredScenario(manifest_.scenario);
  base_.scenario.directory = (folder / manifest_.directory).lexically_normal();
  sortAxes();
  std::unordered_map<std::string, std::size_t> seen;
  for (const std::string& text : manifest_.points.texts()) {
    plain_.push_back(plainText(text));
    text_ids_.push_back(seen.try_emplace(plain_.back(), plain_.size() - 1).first->second);
  }
  makeTasks();
  nameTasks();
}

/// Which axes move nothing, and which entries read each.
void SweepPlan::sortAxes() {
  const Scenario& scenario = base_.scenario;
  const std::vector<std::string>& paths = manifest_.points.paths();
  bool laws_move_nothing = std::none_of(scenario.tools.begin(), scenario.tools.end(),
                                        [](const ToolSettings& tool) { return tool.coupling.has_value(); });
  for (const std::string& path : paths) {
    const std::vector<std::string> parts = partsOf(path);
    Axis& axis = axes_.emplace_back();
    if (parts[0] == "pipelines" && parts.size() > 2) {
      const std::size_t entry = itemAt(scenario.pipelines, parts[1]);
      if (entry < scenario.pipelines.size()) axis.only_entry = scenario.pipelines[entry].name;
    }
    if (parts[0] == "tools" && (parts.size() < 3 || parts[2] == "coupling")) laws_move_nothing = false;
    if (parts[0] != "force") continue;
    axis.law_index = parts.size() == 3 ? itemAt(scenario.force, parts[1]) : scenario.force.size();
    ForceSettings any;
    if (axis.law_index < scenario.force.size() && coefficient(any, parts[2])) {
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
    if (axes_[a].law != laws) continue;
    if (!axes_[a].only_entry.empty() && axes_[a].only_entry != manifest_.pipelines[entry]) continue;
    text += std::to_string(text_ids_[points.indices()[point * axes_.size() + a]]) + ' ';
  }
  return text;
}

void SweepPlan::makeTasks() {
  struct Group {
    std::size_t first_task;  ///< one a repeat
    std::unordered_map<std::string, std::size_t> laws;
  };
  std::unordered_map<std::string, Group> groups;
  const std::size_t entries = manifest_.pipelines.size();
  const int repeats = manifest_.settings.repeats;
  places_.reserve(manifest_.points.size() * entries * static_cast<std::size_t>(repeats));
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
        places_.push_back({task, law->second});
      }
    }
  }
}

void SweepPlan::nameTasks() {
  std::string common = "fissure task 1\n" + manifest_.scenario + "\n";
  for (const auto& [file, hash] : manifest_.inputs) common += file + "=" + hash + "\n";
  if (const auto& curves = manifest_.settings.curves) {
    common += formatReal(curves->every_s) + " " + formatReal(curves->until_s.value_or(0));
    for (const std::string& quantity : curves->quantities) common += " " + quantity;
  }
  common += manifest_.settings.keep == SweepKeep::results ? "\nresults\n" : "\nmetrics\n";
  common = fnv1a64(common);
  const std::size_t axes = axes_.size();
  const auto value = [&](std::size_t point, std::size_t axis) -> const std::string& {
    return plain_[manifest_.points.indices()[point * axes + axis]];
  };
  std::vector<std::size_t> order(axes);  // by path: the order of a sweep file's axes changes no simulation
  for (std::size_t a = 0; a < axes; ++a) order[a] = a;
  const std::vector<std::string>& paths = manifest_.points.paths();
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return paths[a] < paths[b]; });
  for (SweepTask& task : tasks_) {
    std::string text = common + "\n" + manifest_.engines.at(precision(task)) + "\n" +
                       manifest_.pipelines[task.entry] + " " + std::to_string(task.repeat) + "\n";
    for (const std::size_t a : order)
      if (!axes_[a].law && reads(task, a)) text += paths[a] + "=" + value(task.point, a) + "\n";
    for (const std::size_t point : task.laws) {
      for (const std::size_t a : order)
        if (axes_[a].law) text += paths[a] + "=" + value(point, a) + " ";
      text += "\n";
    }
    task.id = fnv1a64(text);
  }
}

bool SweepPlan::reads(const SweepTask& task, std::size_t axis) const {
  return axes_[axis].only_entry.empty() || axes_[axis].only_entry == manifest_.pipelines[task.entry];
}

PlannedRun SweepPlan::run(std::size_t index) const {
  const auto repeats = static_cast<std::size_t>(manifest_.settings.repeats);
  const std::size_t entries = manifest_.pipelines.size();
  const Place& place = places_[index];
  return {index / (entries * repeats), index / repeats % entries, static_cast<int>(index % repeats),
          place.task, place.law};
}

std::vector<Override> SweepPlan::overrides(const SweepTask& task) const {
  std::vector<Override> overrides;
  for (std::size_t a = 0; a < axes_.size(); ++a)
    if (reads(task, a) && !(axes_[a].law && task.laws.size() > 1))
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
    if (!number)
      throw InputError("axis " + manifest_.points.paths()[a] + ": " + text + ", expected a number");
    *coefficient(laws[axes_[a].law_index], axes_[a].coefficient) = *number;
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
  return entry(task.entry).precision;
}

}  // namespace fissure
