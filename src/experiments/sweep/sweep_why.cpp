#include "sweep/sweep_why.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "base/counted.h"
#include "scenario/compose.h"
#include "sweep/plan_text.h"
#include "sweep/sweep_planning.h"

namespace fissure {

namespace {

constexpr std::size_t most_places = 3;  // of a scenario that are named

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

/// How an item of a list is called in a path: by its name, else by its number.
std::string labelOf(const YamlNode& parent, std::size_t index) {
  const YamlNode& child = parent.children[index];
  if (parent.kind == YamlNode::Kind::map) return child.key;
  return itemName(child).value_or(std::to_string(index));
}

std::map<std::string, const YamlNode*> childrenOf(const YamlNode& node) {
  std::map<std::string, const YamlNode*> children;
  for (std::size_t i = 0; i < node.children.size(); ++i)
    children.emplace(labelOf(node, i), &node.children[i]);
  return children;
}

/// Appends the paths of the smallest parts of two scenarios that differ.
void addDifferences(const YamlNode& now, const YamlNode& before, const std::string& path,
                    std::vector<std::string>& places) {
  if (flowText(now) == flowText(before)) return;
  const bool has_parts = now.kind == before.kind && !now.children.empty() && !before.children.empty();
  const std::size_t known = places.size();
  if (has_parts) {
    const auto parts = childrenOf(now), parts_before = childrenOf(before);
    const std::string prefix = path.empty() ? "" : path + ".";
    for (const auto& [name, part] : parts) {
      const auto other = parts_before.find(name);
      if (other == parts_before.end())
        places.push_back(prefix + name);
      else
        addDifferences(*part, *other->second, prefix + name, places);
    }
    for (const auto& [name, part] : parts_before)
      if (!parts.contains(name)) places.push_back(prefix + name);
  }
  if (places.size() == known) places.push_back(path.empty() ? "scenario" : path);  // or another order
}

std::vector<std::string> valuesOf(const SweepPlan& plan, std::size_t entry, std::size_t point, bool laws) {
  const SweepPoints& points = plan.manifest().points;
  std::vector<std::string> lines;
  for (std::size_t a = 0; a < points.paths().size(); ++a)
    if (plan.isLawAxis(a) == laws && plan.reads(entry, a))
      lines.push_back(points.paths()[a] + "=" + plainValue(points.value(point, a)));
  std::sort(lines.begin(), lines.end());
  return lines;
}

/// What makes two tasks of two plans the same simulation for a user: pipeline, repeat, and values that move
/// something.
std::string placeOf(const SweepPlan& plan, const SweepTask& task) {
  return fmt::format("{}\n{}\n{}", plan.manifest().pipelines[task.entry], task.repeat,
                     joined(valuesOf(plan, task.entry, task.point, false)));
}

std::vector<std::string> lawsOf(const SweepPlan& plan, const SweepTask& task) {
  std::vector<std::string> laws;
  for (const std::size_t point : task.laws) laws.push_back(joined(valuesOf(plan, task.entry, point, true)));
  std::sort(laws.begin(), laws.end());
  return laws;
}

/// What a plan says of tasks that an earlier one had.
class Comparison {
 public:
  Comparison(const SweepPlan& plan, const SweepPlan& before) : plan_(plan), before_(before) {
    for (std::size_t i = 0; i < before.tasks().size(); ++i)
      places_.emplace(placeOf(before, before.tasks()[i]), i);
  }

  /// The reason of a task that has no record.
  TaskReason reasonOf(const SweepTask& task) {
    const auto place = places_.find(placeOf(plan_, task));
    if (place == places_.end()) return {WhyRun::added, "added: the plan before has no such simulation"};
    const SweepTask& other = before_.tasks()[place->second];
    if (other.id == task.id) return {WhyRun::no_record, "no record of it"};
    std::vector<std::string> changes = commonChanges(task.entry, other.entry);
    const std::string precision = plan_.precision(task);
    const auto& engines = before_.manifest().engines;
    const auto engine = engines.find(before_.precision(other));
    if (engine == engines.end() || engine->second != plan_.manifest().engines.at(precision))
      changes.push_back("another build of fissure-engine-" + precision);
    const std::size_t laws = task.laws.size(), laws_before = other.laws.size();
    if (laws != laws_before)
      changes.push_back(fmt::format("{} of force laws, {} before", counted(laws, "set"), laws_before));
    else if (lawsOf(plan_, task) != lawsOf(before_, other))
      changes.emplace_back("other coefficients of force laws");
    return {WhyRun::changed, "changed: " + (changes.empty() ? "the way of recording it" : joined(changes))};
  }

 private:
  /// What differs for all tasks of an entry.
  const std::vector<std::string>& commonChanges(std::size_t entry, std::size_t entry_before) {
    const auto [known, is_new] = common_.try_emplace(entry);
    std::vector<std::string>& changes = known->second;
    if (!is_new) return changes;
    addDifferences(physicsOf(plan_.manifest(), entry), physicsOf(before_.manifest(), entry_before), "",
                   changes);
    if (changes.size() > most_places) {
      const std::size_t more = changes.size() - most_places;
      changes.resize(most_places);
      changes.push_back(fmt::format("{} more of the scenario", more));
    }
    addInputs(changes);
    const SweepSettings &now = plan_.manifest().settings, &before = before_.manifest().settings;
    if (curvesText(now) != curvesText(before)) changes.emplace_back("other curves");
    if (now.keep != before.keep)
      changes.emplace_back(now.keep == SweepKeep::results ? "results are kept now"
                                                          : "no results are kept now");
    return changes;
  }

  void addInputs(std::vector<std::string>& changes) const {
    const auto& inputs_before = before_.manifest().inputs;
    for (const auto& [file, hash] : plan_.manifest().inputs) {
      const auto other = inputs_before.find(file);
      if (other != inputs_before.end() && other->second != hash) changes.push_back("another " + file);
    }
  }

  static std::string curvesText(const SweepSettings& settings) {
    if (!settings.curves) return "";
    return fmt::format("{} {} {}", settings.curves->every_s, settings.curves->until_s.value_or(0),
                       joined(settings.curves->quantities));
  }

  const SweepPlan& plan_;
  const SweepPlan& before_;
  std::unordered_map<std::string, std::size_t> places_;  ///< of the tasks before
  std::map<std::size_t, std::vector<std::string>> common_;
};

std::string statusText(const RunStatus& status) {
  return nameOf(status.end) + (status.detail.empty() ? "" : " (" + status.detail + ")");
}

/// The plan in the folder, where it differs from `plan`; nothing where none is there, or where it is damaged.
std::optional<SweepPlan> earlierPlan(const SweepPlan& plan, const std::filesystem::path& folder) {
  refuseOtherFolder(plan.manifest(), folder);
  std::error_code ignored;
  if (!std::filesystem::exists(manifestFile(folder), ignored)) return std::nullopt;
  try {
    SweepManifest manifest = readManifest(folder);
    if (manifestText(manifest) == manifestText(plan.manifest())) return std::nullopt;
    return std::optional<SweepPlan>(std::in_place, std::move(manifest), folder);
  } catch (const InputError&) {  // damaged, or no scenario any more: the plan that replaces it says all
    return std::nullopt;
  }
}

}  // namespace

std::string nameOf(WhyRun why) {
  switch (why) {
    case WhyRun::finished:
      return "finished";
    case WhyRun::other_shard:
      return "other_shard";
    case WhyRun::no_record:
      return "no_record";
    case WhyRun::failed:
      return "failed";
    case WhyRun::lost:
      return "lost";
    case WhyRun::changed:
      return "changed";
    case WhyRun::added:
      return "added";
  }
  return "";
}

std::vector<TaskReason> whyTasksRun(const SweepState& state, const std::filesystem::path& folder,
                                    std::size_t shard, std::size_t shards) {
  const SweepPlan& plan = state.plan();
  const SweepState recorded(plan, folder);
  const std::optional<SweepPlan> earlier = earlierPlan(plan, folder);
  std::optional<Comparison> comparison;
  if (earlier) comparison.emplace(plan, *earlier);
  std::vector<TaskReason> reasons;
  for (std::size_t i = 0; i < plan.tasks().size(); ++i) {
    const SweepState::Task& task = state.task(i);
    const std::size_t own = plan.shardOf(i, shards);
    if (task.finished)
      reasons.push_back({WhyRun::finished, "finished: " + statusText(task.status)});
    else if (own != shard)
      reasons.push_back({WhyRun::other_shard, fmt::format("not here: of shard {}/{}", own + 1, shards)});
    else if (recorded.task(i).finished)
      reasons.push_back({WhyRun::lost, "lost: " + recorded.task(i).file + " is gone or damaged"});
    else if (task.place)
      reasons.push_back({WhyRun::failed, "tried again: " + statusText(task.status)});
    else if (comparison)
      reasons.push_back(comparison->reasonOf(plan.tasks()[i]));
    else
      reasons.push_back({WhyRun::no_record, "no record of it"});
  }
  return reasons;
}

std::vector<std::vector<std::string>> whyRows(const SweepPlan& plan, const std::vector<TaskReason>& reasons) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    const SweepTask& task = plan.tasks()[i];
    rows.push_back({task.id, plan.manifest().pipelines[task.entry], valuesText(plan, task), reasons[i].text});
  }
  return rows;
}

nlohmann::ordered_json whyJson(const SweepPlan& plan, const std::vector<TaskReason>& reasons) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    const SweepTask& task = plan.tasks()[i];
    list.push_back({{"simulation", task.id},
                    {"pipeline", plan.manifest().pipelines[task.entry]},
                    {"values", valuesText(plan, task)},
                    {"why", nameOf(reasons[i].why)},
                    {"text", reasons[i].text},
                    {"runs", reasons[i].runs()}});
  }
  return list;
}

}  // namespace fissure
