#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "base/steps.h"
#include "scenario/range_check.h"
#include "scenario/rigid_tools.h"
#include "scenario/summary_keys.h"
#include "text/scalars.h"

namespace fissure {

namespace {

constexpr double max_pictures = 1e6;
constexpr double max_triangles = 1 << 20;
constexpr double max_nodes = 1 << 21;
constexpr double max_snapshot_values = 4e10;  // 3 a vertex and snapshot

/// Checks the items of a named list, each below its name, or below its index where the name is bad or taken.
/// `seen`: names that are taken; the list's are added.
template <class Item, class Check>
void checkItems(Checker check, const std::vector<Item>& items, Check checkItem, std::set<std::string>& seen) {
  if (items.size() > most_items) return;  // more are refused already
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string& name = items[i].name;
    const bool good = isName(name);
    const bool fresh = seen.insert(name).second;
    Checker item = check.in(good && fresh ? name : std::to_string(i));
    item.require(!good || fresh, "name", "is \"" + name + "\" again, expected each name once");
    checkItem(item, items[i]);
  }
}

template <class Item, class Check>
void checkItems(Checker check, const std::vector<Item>& items, Check checkItem) {
  std::set<std::string> seen;
  checkItems(check, items, checkItem, seen);
}

/// Duration of the run in seconds as far as the scenario says it; nothing if only a log does.
std::optional<double> knownDuration(const Scenario& scenario) {
  if (scenario.time.duration_s) return scenario.time.duration_s;
  double longest_s = 0;
  for (const ToolSettings& tool : scenario.tools) {
    const std::optional<double> motion_s =
        std::visit([](const auto& motion) { return motion.knownDuration_s(); }, tool.motion);
    if (!motion_s) return std::nullopt;
    longest_s = std::max(longest_s, *motion_s);
  }
  return longest_s;
}

/// The duration against the step. Takes good values.
void checkSteps(Checker check, const TimeSettings& time, double duration_s) {
  const std::string step_s = formatReal(time.step_s), duration = formatReal(duration_s);
  if (duration_s == 0)
    return check.fail("", "has no duration_s and no tool moves or holds, expected one of them");
  check.require(time.step_s <= duration_s, "step_s",
                fmt::format("is {}, expected at most the duration, {} s", step_s, duration));
  check.require(duration_s / time.step_s <= max_steps, "step_s",
                fmt::format("is {}, more than 1e8 steps in {} s, expected fewer", step_s, duration));
}

double triangleCount(const Scenario& scenario) {
  double count = 0;
  for (const BodySettings& body : scenario.bodies) count += trianglesOf(body.shape).value_or(0);
  return count;
}

/// Refuses what no machine would hold. Takes good values.
void checkSizes(Checker check, const Scenario& scenario) {
  const double triangles = triangleCount(scenario);
  check.require(triangles <= max_triangles, "bodies",
                fmt::format("have {} triangles together, expected at most {}", formatReal(triangles),
                            formatReal(max_triangles)));
  double nodes = 0;
  for (const ToolSettings& tool : rigidTools(scenario.tools)) {
    if (tool.nodePlacement() == NodePlacement::grid) nodes += tool.nodes.gridCount();
  }
  check.require(
      nodes <= max_nodes, "tools",
      fmt::format("have {} nodes together, expected at most {}", formatReal(nodes), formatReal(max_nodes)));
}

/// A period shorter than the step cannot be kept; equal to it up to rounding is fine.
void checkPeriod(Checker check, const std::string& key, double every_s, double step_s) {
  check.require(
      every_s >= step_s * (1 - step_slack), key,
      fmt::format("is {}, expected at least time.step_s, {}", formatReal(every_s), formatReal(step_s)));
}

/// What is recorded how often against step and duration (if known). Takes good values.
void checkAmounts(Checker check, const Scenario& scenario, std::optional<double> duration_s) {
  const RecordSettings& record = scenario.record;
  check.require(!record.force_inputs || !scenario.force.empty(), "force_inputs",
                "is true, but the scenario has no force law, expected one in `force`");
  const int per_row = stepsPerRow(record, scenario.measure);
  const int per_measurement = stepsPerMeasurement(scenario.measure);
  check.require(per_row % per_measurement == 0, "every",
                fmt::format("is {}, expected a multiple of measure.every, {}", per_row, per_measurement));
  if (record.frames) {
    checkPeriod(check, "frames.every_s", record.frames->every_s, scenario.time.step_s);
    const double pictures = std::floor(duration_s.value_or(0) / record.frames->every_s);
    check.require(pictures <= max_pictures, "frames.every_s",
                  fmt::format("makes {} pictures, expected at most 1e6", formatReal(pictures)));
  }
  if (record.snapshots_every_s) {
    checkPeriod(check, "snapshots_every_s", *record.snapshots_every_s, scenario.time.step_s);
    const double rows = *record.snapshots_every_s / (per_row * scenario.time.step_s);
    check.require(
        per_row == 1 || std::abs(rows - std::round(rows)) < step_slack * rows, "snapshots_every_s",
        fmt::format("is {}, expected a multiple of the time between two rows, {}",
                    formatReal(*record.snapshots_every_s), formatReal(per_row * scenario.time.step_s)));
    // A closed triangle surface has about half as many vertices as triangles.
    const double snapshots = duration_s.value_or(0) / *record.snapshots_every_s;
    const double values = snapshots * triangleCount(scenario) / 2 * 3;
    check.require(
        values <= max_snapshot_values, "snapshots_every_s",
        fmt::format("makes about {} numbers, expected at most 4e10", formatReal(std::round(values))));
  }
}

/// Friction is a share of the contacts' force, and response none knows none.
void checkFriction(Checker check, const Scenario& scenario) {
  for (const ToolSettings& tool : scenario.tools) {
    for (const PipelineSettings& entry : scenario.pipelines) {
      check.require(tool.friction == 0 || entry.hasFriction(), tool.name + ".friction",
                    fmt::format("is {0}, but run {1} has response none and with it no force to rub with, "
                                "expected 0 or pipelines.{1}.response momentum",
                                formatReal(tool.friction), entry.name));
    }
  }
}

/// A tool that contacts push needs contacts that share momentum with it, in the scene's own time.
void checkReaction(Checker check, const Scenario& scenario, const std::string& key) {
  for (const PipelineSettings& entry : scenario.pipelines) {
    check.require(
        entry.usesSurface() || (entry.usesNodes() && entry.hasFriction()), key,
        fmt::format(
            "is reaction, but the contacts of run {} push no tool, expected {}, or {} with response momentum",
            entry.name, pipelinesWith({ContactDetection::surface}),
            pipelinesWith({ContactDetection::nodes})));
  }
  for (const BodySettings& body : scenario.bodies) {
    check.require(
        body.timeScale() == 1, key,
        fmt::format(
            "is reaction, but bodies.{}.solver.time_scale is {}, expected 1: tool and tissue share one time",
            body.name, formatReal(body.timeScale())));
  }
  for (const ForceSettings& law : scenario.force) {
    check.require(law.name != "reaction", key,
                  "is reaction, but an entry of force has that name, expected another name for it");
  }
}

void checkCouplings(Checker check, const Scenario& scenario) {
  for (const ToolSettings& tool : scenario.tools) {
    if (!tool.coupling) continue;
    if (tool.coupling->isPushedByContacts()) {
      checkReaction(check, scenario, tool.name + ".coupling.force");
      continue;
    }
    const bool known =
        std::any_of(scenario.force.begin(), scenario.force.end(),
                    [&](const ForceSettings& law) { return law.name == tool.coupling->force; });
    check.require(
        known, tool.name + ".coupling.force",
        fmt::format("is \"{}\", expected the name of an entry of force, or reaction", tool.coupling->force));
  }
}

/// Relations between values that are good each by itself.
void checkRelations(Checker check, const Scenario& scenario) {
  const std::optional<double> duration_s = knownDuration(scenario);
  Checker time = check.in("time");
  time.require(scenario.time.settle_s / scenario.time.step_s <= max_steps, "settle_s",
               "takes more than 1e8 steps, expected fewer");
  if (duration_s) checkSteps(time, scenario.time, *duration_s);
  checkSizes(check, scenario);
  checkFriction(check.in("tools"), scenario);
  checkJawNames(check.in("tools"), scenario.tools);
  checkCouplings(check.in("tools"), scenario);
  checkElasticScene(check, scenario);
  checkSummaryKeys(check, scenario);
  checkAmounts(check.in("record"), scenario, duration_s);
}

}  // namespace

bool isName(std::string_view text) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) || c == '_' || c == '-');
  });
}

std::vector<Problem> validate(const Scenario& scenario) {
  std::vector<Problem> problems;
  Checker check(problems, "");
  checkRanges(check, scenario);
  checkItems(check.in("bodies"), scenario.bodies, checkBody);
  std::set<std::string> gauges;
  for (const BodySettings& body : scenario.bodies) {
    Checker of_body = check.in("bodies").in(body.name);
    checkItems(
        of_body.in("gauges"), body.gauges,
        [](Checker gauge, const GaugeSettings& settings) { checkBox(gauge.in("box"), settings.box); },
        gauges);
    checkItems(of_body.in("elastic").in("regions"), body.elastic.regions, checkElasticRegion);
  }
  checkItems(check.in("tools"), scenario.tools, checkTool);
  checkItems(check.in("pipelines"), scenario.pipelines, checkPipeline);
  checkItems(check.in("force"), scenario.force, checkForce);
  checkRecord(check.in("record"), scenario.record);
  checkExpectations(check.in("expect"), scenario);
  // Relations between bad values would only hide what is wrong.
  if (problems.empty()) checkRelations(check, scenario);
  return problems;
}

}  // namespace fissure
