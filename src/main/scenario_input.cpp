#include "main/scenario_input.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/check.h"
#include "mesh/fixed_vertices.h"
#include "mesh/place.h"
#include "motion/motion.h"
#include "scenario/did_you_mean.h"

namespace fissure {

namespace {

std::vector<Override> parseOverrides(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw InputError("--set " + text + ": not an override, expected path=value");
    overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return overrides;
}

/// Keeps the pipelines named, in the scenario's order.
void select(const std::vector<std::string>& names, CheckedScenario& checked) {
  if (names.empty()) return;
  std::vector<PipelineSettings>& pipelines = checked.loaded.scenario.pipelines;
  std::vector<std::string> known;
  known.reserve(pipelines.size());
  for (const PipelineSettings& entry : pipelines) known.push_back(entry.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(checked.file.string() + ": no pipeline \"" + name + "\"" + didYouMean(name, known));
  const auto dropped = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) == names.end();
  };
  std::erase_if(pipelines, [&](const PipelineSettings& entry) { return dropped(entry.name); });
  std::erase_if(checked.loaded.scenario.expect, [&](const Expectation& expected) {
    return expected.pipeline && dropped(*expected.pipeline);
  });
}

void checkFixed(const std::string& file, const BodySettings& body, const TriangleMesh& rest) {
  const std::string where = file + ": bodies." + body.name + ".fixed";
  for (std::size_t i = 0; i < body.fixed.size(); ++i) {
    if (verticesIn(body.fixed[i], rest).empty())
      throw InputError(where + "." + std::to_string(i) +
                       " holds no vertex of the body as it is placed, expected at least one");
  }
  if (fixedVertices(body, rest).size() == rest.vertices_m.size())
    throw InputError(where + " holds every vertex of the body, expected some that can move");
}

void checkBodies(const CheckedScenario& checked) {
  for (const BodySettings& body : checked.loaded.scenario.bodies) {
    const TriangleMesh rest = placeBody(body);
    const std::vector<std::string> defects = findDefects(rest);
    checkFixed(checked.file.string(), body, rest);
    if (defects.empty()) continue;
    std::string all;
    for (const std::string& defect : defects) all += (all.empty() ? "" : "; ") + defect;
    throw InputError(checked.file.string() + ": bodies." + body.name + ".shape: " + all +
                     ", expected a closed surface with outward faces");
  }
}

/// Seconds until the last tool stands still; reads every log.
double longestMotion_s(const Scenario& scenario) {
  double longest_s = 0;
  for (const ToolSettings& tool : scenario.tools)
    longest_s = std::max(longest_s, makeMotion(tool, scenario.directory)->duration_s());
  return longest_s;
}

}  // namespace

CheckedScenario checkScenario(const std::filesystem::path& file, const Selection& selection) {
  CheckedScenario checked{file, loadScenario(file, parseOverrides(selection.overrides)), 0, 0};
  Scenario& scenario = checked.loaded.scenario;
  select(selection.pipelines, checked);
  if (!selection.frames) scenario.record.frames.reset();
  if (!selection.expectations) scenario.expect.clear();
  checked.loaded.resolved = toYaml(scenario);
  checkBodies(checked);
  const double longest_s = longestMotion_s(scenario);
  checked.duration_s = scenario.time.duration_s.value_or(longest_s);
  const double steps = stepsToCover(checked.duration_s, scenario.time.step_s);
  if (!(steps <= max_steps))
    throw InputError(file.string() +
                     ": time.step_s: the motion of a tool lasts more than 1e8 steps, expected fewer");
  checked.steps = static_cast<std::int64_t>(steps);
  if (checked.steps < 1)
    throw InputError(file.string() +
                     ": time.duration_s: the run has no step, expected a duration of at least one step_s, "
                     "given or by the motion of a tool");
  return checked;
}

}  // namespace fissure
