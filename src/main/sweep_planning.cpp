#include "main/sweep_planning.h"

#include <algorithm>
#include <fstream>
#include <set>

#include "base/error.h"
#include "base/hash.h"
#include "main/run_plan.h"
#include "main/scenario_input.h"
#include "process/engine_program.h"
#include "scenario/did_you_mean.h"
#include "scenario/scalars.h"
#include "scenario/text_file.h"
#include "store/temporary_file.h"
#include "study/run_recorder.h"
#include "study/sweep_misfit.h"
#include "study/sweep_plan.h"
#include "study/sweep_state.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_checks = 1000;

std::string hashOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  if (!stream) throw InputError(file.string() + ": cannot be read");
  return "fnv1a64:" + fnv1a64(bytes);
}

std::string nameFrom(const fs::path& directory, const fs::path& file) {
  const fs::path name = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(directory));
  return name.empty() ? fs::weakly_canonical(file).string() : name.generic_string();
}

void refuseTooMany(const fs::path& file, double runs, bool many) {
  const std::string found = file.string() + ": plans " + formatReal(runs) + " runs";
  if (runs > max_sweep_runs) throw InputError(found + ", expected at most " + formatReal(max_sweep_runs));
  if (runs > many_sweep_runs && !many)
    throw InputError(found + ", expected at most " + formatReal(many_sweep_runs) + ", or --yes");
}

/// An axis is set as an override is, but it is not on the command line.
std::string aboutAxes(std::string message) {
  constexpr std::string_view set = "--set ";
  for (std::size_t at = 0; (at = message.find(set, at)) != std::string::npos;)
    message.replace(at, set.size(), "axis ");
  return message;
}

/// Points in which every value of every axis is at least once.
std::vector<std::size_t> pointsToCheck(const SweepPoints& points) {
  const std::size_t axes = points.paths().size();
  std::vector<bool> seen(points.texts().size(), false);
  std::vector<std::size_t> chosen;
  for (std::size_t point = 0; point < points.size(); ++point) {
    bool has_new = false;
    for (std::size_t a = 0; a < axes; ++a) {
      const std::size_t text = points.indices()[point * axes + a];
      has_new |= !seen[text];
      seen[text] = true;
    }
    if (has_new) chosen.push_back(point);
  }
  if (chosen.size() <= most_checks) return chosen;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < most_checks; ++i)
    some.push_back(chosen[i * (chosen.size() - 1) / (most_checks - 1)]);
  return some;
}

/// Nothing is there, or what a planner left that was killed before there was a plan.
bool isFree(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return true;
  if (!fs::is_directory(folder, ignored)) return false;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename() != journalFolder("").filename()) return false;
  return true;
}

class Planner {
 public:
  Planner(fs::path file, fs::path folder, bool many) : file_(std::move(file)), folder_(std::move(folder)) {
    manifest_.settings = loadSweep(file_);
    const fs::path base = manifest_.settings.directory / manifest_.settings.base;
    const CheckedScenario checked = checkScenario(base, {manifest_.settings.pipelines, {}, true, false});
    base_ = checked.loaded;
    manifest_.scenario = base_.composed;
    manifest_.directory = nameFrom(folder_, base_.scenario.directory);
    for (const PipelineSettings& entry : base_.scenario.pipelines) manifest_.pipelines.push_back(entry.name);
    const double runs = SweepPoints::designed(manifest_.settings) *
                        static_cast<double>(manifest_.pipelines.size()) * manifest_.settings.repeats;
    refuseTooMany(file_, runs, many);
    manifest_.points = SweepPoints(manifest_.settings);
    if (manifest_.points.size() == 0)
      throw InputError(file_.string() + ": exclude leaves no point, expected some");
    addEngines();
    addFit();
    checkPoints();
  }

  SweepManifest take() { return std::move(manifest_); }

 private:
  void addEngines() {
    std::set<std::string> precisions;
    for (const PipelineSettings& entry : base_.scenario.pipelines) precisions.insert(entry.precision);
    const std::vector<std::string>& paths = manifest_.points.paths();
    if (std::any_of(paths.begin(), paths.end(),
                    [](const std::string& p) { return p.ends_with(".precision"); }))
      precisions = {"f32", "f64"};
    for (const std::string& precision : precisions)
      manifest_.engines[precision] = hashOf(engineProgram(precision));
  }

  void addFit() {
    const std::optional<SweepFit>& fit = manifest_.settings.fit;
    if (!fit) return;
    const fs::path curve = manifest_.settings.directory / fit->curve;
    manifest_.measured = readTextFile(curve);
    const std::vector<ForceSettings>& laws = base_.scenario.force;
    std::vector<std::string> names;
    for (const ForceSettings& law : laws) names.push_back(law.name);
    if (fit->law && std::find(names.begin(), names.end(), *fit->law) == names.end())
      throw InputError(file_.string() + ": fit.law: no force law \"" + *fit->law + "\"" +
                       didYouMean(*fit->law, names));
    SweepMisfit(*fit, names, curve);
  }

  void checkPoints() {
    const SweepPoints& points = manifest_.points;
    for (const std::size_t point : pointsToCheck(points)) {
      std::vector<Override> overrides;
      for (std::size_t a = 0; a < points.paths().size(); ++a)
        overrides.push_back({points.paths()[a], points.value(point, a)});
      try {
        checkPoint(parseScenario(base_.composed, base_.scenario.directory / "base", overrides));
      } catch (const InputError& error) {
        throw InputError(file_.string() + ": " + aboutAxes(error.what()));
      }
    }
  }

  void checkPoint(LoadedScenario loaded) {
    for (const fs::path& input : loaded.inputs) {
      const std::string name = nameFrom(base_.scenario.directory, input);
      if (!manifest_.inputs.contains(name)) manifest_.inputs[name] = hashOf(input);
    }
    const CheckedScenario checked =
        checkLoaded("base", std::move(loaded), {manifest_.settings.pipelines, {}, true, false});
    std::optional<SweepCurves>& curves = manifest_.settings.curves;
    if (!curves || checked_curves_) return;
    checked_curves_ = true;
    if (!curves->until_s) curves->until_s = std::max(checked.duration_s, curves->every_s);
    const Scenario& scenario = checked.loaded.scenario;
    manifest_.curves = curveQuantities(curves->quantities, layoutOf(scenario, scenario.pipelines.front()),
                                       "curves.quantities");
  }

  fs::path file_, folder_;
  LoadedScenario base_;
  SweepManifest manifest_;
  bool checked_curves_ = false;
};

}  // namespace

SweepManifest planSweep(const fs::path& file, const fs::path& folder, bool many) {
  return Planner(file, folder, many).take();
}

void putManifest(const SweepManifest& manifest, const fs::path& folder) {
  std::error_code error;
  if (fs::exists(manifestFile(folder), error)) {
    const std::string name = readManifest(folder).settings.name;
    if (name != manifest.settings.name)
      throw InputError(folder.string() + ": holds the sweep \"" + name +
                       "\", expected another folder for \"" + manifest.settings.name + "\"");
  } else if (!isFree(folder)) {
    throw InputError(folder.string() + ": is no folder of a sweep, expected a new name or an empty folder");
  }
  const JournalWriter place(journalFolder(folder));  // for its folder alone
  const fs::path made = manifestFile(place.work());
  try {
    TemporaryFile file(made);
    file.write(manifestText(manifest));
    file.commit();
  } catch (const RunError& failure) {
    throw RunError(manifestFile(folder).string() + ": " + failure.what());
  }
  fs::rename(made, manifestFile(folder), error);
  if (error) throw RunError(manifestFile(folder).string() + ": cannot be written: " + error.message());
}

void refuseOtherPlan(const SweepManifest& manifest, const fs::path& folder) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(folder.string() + ": was planned with another " + what +
                     ", expected its sweep file to plan it again");
  };
  for (const auto& [precision, hash] : manifest.engines) {
    const fs::path program = engineProgram(precision);
    if (hashOf(program) != hash) refuse(program.filename().string());
  }
  for (const auto& [name, hash] : manifest.inputs)
    if (hashOf(folder / manifest.directory / name) != hash) refuse(name);
}

}  // namespace fissure
