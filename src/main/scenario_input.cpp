#include "main/scenario_input.h"

#include <algorithm>
#include <cmath>

#include "mesh/check.h"
#include "mesh/file_surface.h"
#include "mesh/fixed_vertices.h"
#include "mesh/place.h"
#include "motion/motion.h"
#include "process/apart.h"
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

void checkGauges(const std::string& file, const BodySettings& body, const TriangleMesh& rest) {
  for (const GaugeSettings& gauge : body.gauges) {
    if (verticesIn(gauge.box, rest).empty())
      throw InputError(file + ": bodies." + body.name + ".gauges." + gauge.name +
                       " holds no vertex of the body as it is placed, expected at least one");
  }
}

std::vector<std::string> spoiling(const std::vector<Defect>& defects) {
  std::vector<std::string> texts;
  for (const Defect& defect : defects)
    if (spoilsBody(defect.kind)) texts.push_back(defect.text);
  return texts;
}

/// All there is to say about the surface of a file, a line each.
void noteSurface(const FileSurface& surface, const std::string& path, std::vector<std::string>& notes) {
  const auto note = [&](const std::string& text) { notes.push_back(path + ": " + text); };
  if (!surface.repairs.empty())
    for (const Defect& defect : surface.found) note("in the file " + defect.text);
  for (const std::string& repair : surface.repairs) note("repaired, " + repair);
  for (const Defect& defect : surface.left) note(defect.text);
}

/// What a body cannot be simulated with. `notes` take what can be said besides.
std::vector<std::string> defectsOf(const BodySettings& body, const std::string& path,
                                   const std::filesystem::path& directory, std::vector<std::string>& notes) {
  const auto* shape = std::get_if<FileShape>(&body.shape);
  if (!shape) return findDefects(placeBody(body, directory));
  // Assimp may crash on a damaged file, or never end.
  tryReading(directory / shape->file, [&] { loadSurface(*shape, directory); });
  const FileSurface surface = loadSurface(*shape, directory);
  noteSurface(surface, path, notes);
  return spoiling(surface.left);
}

/// Adds what is wrong with a body's surface to `all`, and line by line to `lines`.
void reportDefects(const BodySettings& body, const std::string& path, const std::vector<std::string>& defects,
                   std::string& all, std::vector<std::string>& lines) {
  const std::string expected = "expected a closed surface with outward faces";
  std::string line = path;
  line.append(": cannot be simulated, ").append(expected);
  all.append(all.empty() ? "" : "; ").append(path).append(": ");
  for (const std::string& defect : defects) {
    if (!std::holds_alternative<FileShape>(body.shape))
      lines.push_back(std::string(path).append(": ").append(defect));
    all.append(&defect == &defects.front() ? "" : "; ").append(defect);
  }
  lines.push_back(std::move(line));
  all.append(", ").append(expected);
}

void checkBodies(CheckedScenario& checked) {
  const Scenario& scenario = checked.loaded.scenario;
  std::string all;
  std::vector<std::string> lines;
  for (const BodySettings& body : scenario.bodies) {
    const std::string path = "bodies." + body.name + ".shape";
    const std::vector<std::string> defects = defectsOf(body, path, scenario.directory, checked.notes);
    if (!defects.empty()) {
      reportDefects(body, path, defects, all, lines);
    } else if (!body.fixed.empty() || !body.gauges.empty()) {
      const TriangleMesh rest = placeBody(body, scenario.directory);
      if (!body.fixed.empty()) checkFixed(checked.file.string(), body, rest);
      checkGauges(checked.file.string(), body, rest);
    }
  }
  if (all.empty()) return;
  lines.insert(lines.begin(), checked.notes.begin(), checked.notes.end());
  for (std::string& line : lines) line.insert(0, checked.file.string() + ": ");
  throw BadSurfaces(checked.file.string() + ": " + all, std::move(lines));
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
  CheckedScenario checked{file, loadScenario(file, parseOverrides(selection.overrides)), 0, 0, {}};
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
