#include "check/scenario_input.h"

#include <algorithm>
#include <cmath>

#include "base/steps.h"
#include "measure/penetration.h"
#include "mesh/check.h"
#include "mesh/convex.h"
#include "mesh/tetrahedra_check.h"
#include "process/apart.h"
#include "scene/build_scene.h"
#include "scene/fixed_vertices.h"
#include "scene/place.h"
#include "stepping/substep_plan.h"
#include "text/did_you_mean.h"
#include "volume/mesh_files.h"

namespace fissure {

namespace {

std::vector<Override> parseOverrides(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw InputError(ofOverride(text), "not an override, expected path=value");
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
      throw InputError(inFile(checked.file), "no pipeline \"" + name + "\"" + didYouMean(name, known));
  const auto dropped = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) == names.end();
  };
  std::erase_if(pipelines, [&](const PipelineSettings& entry) { return dropped(entry.name); });
  std::erase_if(checked.loaded.scenario.expect, [&](const Expectation& expected) {
    return expected.pipeline && dropped(*expected.pipeline);
  });
}

void checkFixed(const std::string& file, const BodySettings& body, const TriangleMesh& rest) {
  const std::string where = "bodies." + body.name + ".fixed";
  for (std::size_t i = 0; i < body.fixed.size(); ++i) {
    if (verticesIn(body.fixed[i], rest).empty())
      throw InputError(inFile(file),
                       where + "." + std::to_string(i) +
                           " holds no vertex of the body as it is placed, expected at least one");
  }
  if (fixedVertices(body, rest.vertices_m).size() == rest.vertices_m.size())
    throw InputError(inFile(file), where + " holds every vertex of the body, expected some that can move");
}

void checkGauges(const std::string& file, const BodySettings& body, const TriangleMesh& rest) {
  for (const GaugeSettings& gauge : body.gauges) {
    if (verticesIn(gauge.box, rest).empty())
      throw InputError(inFile(file),
                       "bodies." + body.name + ".gauges." + gauge.name +
                           " holds no vertex of the body as it is placed, expected at least one");
  }
}

using Spoils = bool (*)(DefectKind);

std::vector<std::string> spoiling(const std::vector<Defect>& defects, Spoils spoils) {
  std::vector<std::string> texts;
  for (const Defect& defect : defects)
    if (spoils(defect.kind)) texts.push_back(defect.text);
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

/// What is wrong with the surfaces of a scenario, and what can be said about them besides.
class SurfaceReport {
 public:
  SurfaceReport(CheckedScenario& checked, const MeshFiles& files, std::string what, std::string expected,
                Spoils spoils)
      : checked_(checked),
        files_(files),
        what_(std::move(what)),
        expected_(std::move(expected)),
        spoils_(spoils) {}

  /// Looks at the shape at `path`; true when it is good.
  bool check(const SurfaceShape& shape, const std::string& path) {
    const std::vector<std::string> defects = defectsOf(shape, path);
    if (defects.empty()) return true;
    all_.append(all_.empty() ? "" : "; ").append(path).append(": ");
    for (const std::string& defect : defects) {
      if (!std::holds_alternative<FileShape>(shape))
        report_.push_back(std::string(path).append(": ").append(defect));
      all_.append(&defect == &defects.front() ? "" : "; ").append(defect);
    }
    report_.push_back(path + ": " + what_ + ", " + expected_);
    all_.append(", ").append(expected_);
    return false;
  }

  /// Throws BadSurfaces when one was not.
  void finish() {
    if (all_.empty()) return;
    report_.insert(report_.begin(), checked_.notes.begin(), checked_.notes.end());
    const Origin origin = inFile(checked_.file);
    for (std::string& line : report_) line.insert(0, origin.beginning());
    throw BadSurfaces(origin, all_, std::move(report_));
  }

 private:
  std::vector<std::string> defectsOf(const SurfaceShape& shape, const std::string& path) {
    const std::filesystem::path& directory = checked_.loaded.scenario.directory;
    if (const auto* volume = std::get_if<TetrahedraShape>(&shape)) {
      for (const std::string& note : files_.volume(*volume).notes)
        checked_.notes.push_back(std::string(path).append(": ").append(note));
      return spoiling(inspectSurface(makeSurface(shape, files_)), spoils_);
    }
    const auto* from_file = std::get_if<FileShape>(&shape);
    if (!from_file) return spoiling(inspectSurface(makeSurface(shape)), spoils_);
    // Assimp may crash on a damaged file, or never end.
    tryReading(directory / from_file->file, [&] { loadSurface(*from_file, directory); });
    const FileSurface& surface = files_.surface(*from_file);
    noteSurface(surface, path, checked_.notes);
    return spoiling(surface.left, spoils_);
  }

  CheckedScenario& checked_;
  const MeshFiles& files_;
  std::string what_, expected_;
  Spoils spoils_;
  std::string all_;
  std::vector<std::string> report_;
};

void checkBodies(CheckedScenario& checked, const MeshFiles& files) {
  const Scenario& scenario = checked.loaded.scenario;
  SurfaceReport report(checked, files, "cannot be simulated", "expected a closed surface with outward faces",
                       spoilsBody);
  for (const BodySettings& body : scenario.bodies) {
    if (!report.check(body.shape, "bodies." + body.name + ".shape")) continue;
    if (body.fixed.empty() && body.gauges.empty()) continue;
    const TriangleMesh rest = placeBody(body, files);
    if (!body.fixed.empty()) checkFixed(checked.file.string(), body, rest);
    checkGauges(checked.file.string(), body, rest);
  }
  report.finish();
}

/// What the pipelines need of a tool: Bullet's soft bodies meet convex solids alone, `prescribed` holds
/// tissue to the faces of a box, and ray casting starts at nodes.
void checkTool(const CheckedScenario& checked, const SceneTool& tool) {
  const bool convex = tool.closed && isConvex(tool.surface);
  for (const PipelineSettings& entry : checked.loaded.scenario.pipelines) {
    const auto refuse = [&](const char* what, const char* needs, const std::string& expected) {
      throw InputError(inFile(checked.file),
                       "tools." + tool.name + ".shape " + what + ", and run " + entry.name + " (pipeline " +
                           std::string(entry.traits().name) + ") needs " + needs + ", expected " + expected);
    };
    switch (entry.traits().need) {
      case ToolNeed::convex_and_closed:
        if (!convex)
          refuse("is not convex and closed", "that",
                 pipelinesWith({ContactDetection::nodes, ContactDetection::surface}) + " alone");
        break;
      case ToolNeed::box:
        if (!tool.box_size_m) refuse("is no box", "one", "another pipeline");
        break;
      case ToolNeed::surface:
        break;
      case ToolNeed::nodes:
        if (tool.nodes.size() == 0)
          refuse("gives no triangle a node (no ray back into it leaves it again)", "nodes",
                 "outward faces on both its sides, or nodes.lone_nodes");
        break;
    }
  }
}

Scene sceneOf(const CheckedScenario& checked, const MeshFiles& files) {
  const Scenario& scenario = checked.loaded.scenario;
  const bool with_nodes = std::any_of(scenario.pipelines.begin(), scenario.pipelines.end(),
                                      [](const PipelineSettings& entry) { return entry.usesNodes(); });
  try {
    return buildScene(scenario, with_nodes, files);
  } catch (const InputError& error) {
    throw InputError(inFile(checked.file), error.what());
  }
}

/// A run would only find when it starts that tools cannot be sampled as finely as the scenario says.
void checkSamples(const CheckedScenario& checked) {
  const Scenario& scenario = checked.loaded.scenario;
  if (!scenario.measure.sample_spacing_m) return;
  try {
    const PenetrationMeter meter(checked.prepared.scene, scenario.measure);
  } catch (const InputError& error) {
    throw InputError(inFile(checked.file), error.what());
  }
}

void checkTools(CheckedScenario& checked, const MeshFiles& files) {
  const Scenario& scenario = checked.loaded.scenario;
  SurfaceReport report(checked, files, "cannot be used", "expected faces that agree about the outside",
                       spoilsTool);
  for (const ToolSettings& tool : scenario.tools) {
    const std::string path = "tools." + tool.name;
    report.check(tool.shape, path + ".shape");
    if (!tool.clamp) continue;
    if (tool.clamp->left_jaw) report.check(tool.clamp->left_jaw->shape, path + ".clamp.left_jaw.shape");
    for (std::size_t i = 0; i < tool.clamp->handle.size(); ++i)
      report.check(tool.clamp->handle[i].shape, path + ".clamp.handle." + std::to_string(i) + ".shape");
  }
  report.finish();
}

/// Where a body or one of its regions names a material and says other numbers.
template <class Material>
void notePreset(const std::string& path, const Material& material, std::vector<std::string>& notes) {
  Material preset = material;
  applyPreset(preset);
  if (preset != material)
    notes.push_back(path + ": modulus, ratio or density are given, and not those of preset " +
                    *material.preset);
}

/// Checks the volume and the step of the elastic body, where there is one; notes what is odd about it.
void checkElastic(CheckedScenario& checked) {
  const Scenario& scenario = checked.loaded.scenario;
  const SceneBody& body = checked.prepared.scene.bodies.at(0);
  if (!body.volume) return;
  const std::string path = "bodies." + body.name + ".shape: ";
  for (const VolumeDefect& defect : inspectTetrahedra(body.volume->mesh, body.rest)) {
    if (spoilsVolume(defect.kind))
      throw InputError(inFile(checked.file), path + defect.text + ", expected a volume of sound tetrahedra");
    checked.notes.push_back(path + defect.text);
  }
  const std::string elastic = "bodies." + body.name + ".elastic";
  notePreset(elastic, scenario.bodies[0].elastic, checked.notes);
  for (const ElasticRegion& region : scenario.bodies[0].elastic.regions)
    notePreset(elastic + ".regions." + region.name, region, checked.notes);
  try {
    checkSubsteps(scenario.bodies[0], body, scenario.time.step_s);
  } catch (const InputError& error) {
    throw InputError(inFile(checked.file), error.what());
  }
}

}  // namespace

CheckedScenario checkScenario(const std::filesystem::path& file, const Selection& selection) {
  return checkLoaded(file, loadScenario(file, parseOverrides(selection.overrides)), selection);
}

CheckedScenario checkLoaded(const std::filesystem::path& file, LoadedScenario loaded,
                            const Selection& selection) {
  CheckedScenario checked{.file = file, .loaded = std::move(loaded)};
  Scenario& scenario = checked.loaded.scenario;
  select(selection.pipelines, checked);
  if (!selection.frames) scenario.record.frames.reset();
  if (!selection.expectations) scenario.expect.clear();
  checked.loaded.resolved = toYaml(scenario);
  const MeshFiles files(scenario.directory);
  checkBodies(checked, files);
  checkTools(checked, files);
  PreparedScenario& prepared = checked.prepared;
  prepared.scene = sceneOf(checked, files);
  for (const SceneTool& tool : prepared.scene.tools) checkTool(checked, tool);
  checkSamples(checked);
  checkElastic(checked);
  prepared.motions = makeMotions(scenario);
  for (std::size_t t = 0; t < prepared.motions.size(); ++t)
    for (const std::string& note : prepared.motions[t]->notes())
      checked.notes.push_back("tools." + scenario.tools[t].name + ".motion: " + note);
  checked.duration_s = scenario.time.duration_s.value_or(prepared.longestMotion_s());
  const double steps = stepsToCover(checked.duration_s, scenario.time.step_s);
  if (!(steps <= max_steps))
    throw InputError(inFile(file),
                     "time.step_s: the motion of a tool lasts more than 1e8 steps, expected fewer");
  checked.steps = static_cast<std::int64_t>(steps);
  if (checked.steps < 1)
    throw InputError(inFile(file),
                     "time.duration_s: the run has no step, expected a duration of at least one step_s, "
                     "given or by the motion of a tool");
  return checked;
}

}  // namespace fissure
