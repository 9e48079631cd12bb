#include "scenario/summary_keys.h"

#include <fmt/core.h>

#include <algorithm>

#include "scenario/rigid_tools.h"

namespace fissure {

namespace {

using Endings = std::vector<const char*>;

/// Collects keys.
class Keys {
 public:
  void add(std::string key, std::vector<std::string> owners) {
    keys_.push_back({std::move(key), std::move(owners)});
  }
  /// The keys of one item: its name, then each ending.
  void add(const std::string& name, const std::string& owner, const Endings& endings) {
    for (const char* ending : endings) add(name + ending, {owner});
  }
  std::vector<NamedKey> take() { return std::move(keys_); }

 private:
  std::vector<NamedKey> keys_;
};

void addLaw(const std::string& law, const std::string& owner, Keys& keys) {
  keys.add("max_force_" + law + "_N", {owner});
  for (const char* what : {"force_roughness_", "roughness_same_triangles_", "tool_force_roughness_",
                           "saturated_steps_", "force_non_finite_at_step_"})
    keys.add(what + law, {owner});
}

void addClamp(const ToolSettings& tool, const std::string& owner, const Scenario& scenario, Keys& keys) {
  for (const std::string& jaw : jawNames(tool))
    keys.add(jaw, owner, {"_max_speed_m_s", "_max_acceleration_m_s2"});
  keys.add(tool.name, owner, {"_final_reaction_N"});
  for (const ForceSettings& law : scenario.force)
    for (const char* what : {"_max_resultant_", "_left_max_force_", "_right_max_force_"})
      keys.add(tool.name + what + law.name + "_N", {owner, "force." + law.name});
}

void addTool(const ToolSettings& tool, const Scenario& scenario, Keys& keys) {
  const std::string owner = "tools." + tool.name;
  if (tool.clamp) addClamp(tool, owner, scenario, keys);
  if (!tool.clamp) keys.add(tool.name, owner, {"_max_speed_m_s", "_max_acceleration_m_s2"});
  if (tool.coupling)
    keys.add(tool.name, owner,
             {"_max_coupling_force_N", "_max_lag_m", "_final_lag_m", "_coupling_saturated_steps"});
  if (std::holds_alternative<ReplayMotion>(tool.motion))
    keys.add(tool.name + "_replay", owner,
             {"_samples", "_held_samples", "_gaps", "_jumps", "_fast_steps", "_dropped_rows",
              "_rows_beyond_reason", "_repeated_rows", "_filtered_rows", "_saturated_openings"});
}

}  // namespace

std::vector<NamedKey> namedSummaryKeys(const Scenario& scenario) {
  Keys keys;
  for (const ForceSettings& law : scenario.force) addLaw(law.name, "force." + law.name, keys);
  for (const ToolSettings& tool : scenario.tools) addTool(tool, scenario, keys);
  for (const BodySettings& body : scenario.bodies)
    for (const GaugeSettings& gauge : body.gauges)
      for (const char* axis : {"_x", "_y", "_z"})
        keys.add("gauge_" + gauge.name + axis, "bodies." + body.name + ".gauges." + gauge.name,
                 {"_min_m", "_max_m", "_final_m"});
  return keys.take();
}

void checkSummaryKeys(Checker check, const Scenario& scenario) {
  std::vector<NamedKey> keys = namedSummaryKeys(scenario);
  std::stable_sort(keys.begin(), keys.end(),
                   [](const NamedKey& one, const NamedKey& other) { return one.key < other.key; });
  const auto both =
      std::adjacent_find(keys.begin(), keys.end(),
                         [](const NamedKey& one, const NamedKey& other) { return one.key == other.key; });
  if (both == keys.end()) return;
  const std::vector<std::string>& owners = both->owners;
  std::vector<std::string> others(owners.begin() + 1, owners.end());
  others.insert(others.end(), (both + 1)->owners.begin(), (both + 1)->owners.end());
  check.fail(
      owners.front(),
      fmt::format("makes the summary's key \"{}\", and so do other names, expected a key for each value",
                  both->key),
      others);
}

}  // namespace fissure
