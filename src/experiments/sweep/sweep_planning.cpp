#include "sweep/sweep_planning.h"

#include <fmt/core.h>

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

#include "base/error.h"
#include "batch/engine_program.h"
#include "check/run_plan.h"
#include "check/scenario_input.h"
#include "files/temporary_file.h"
#include "process/line_splitter.h"
#include "scenario/catalog.h"
#include "scenario/compose.h"
#include "sweep/file_stamp.h"
#include "sweep/sweep_misfit.h"
#include "sweep/sweep_plan.h"
#include "sweep/sweep_state.h"
#include "task/curves.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_checks = 1000;

std::string hashOf(const fs::path& file) {
  const std::optional<std::string> hash = knownHash(file);
  if (!hash) throw InputError(inFile(file), "cannot be read");
  return *hash;
}

/// Absolute also where nothing of it is there yet.
fs::path wholePath(const fs::path& path) {
  return fs::weakly_canonical(fs::current_path() / path);
}

/// `file` as it is called from `directory`, whatever links lead there.
std::string nameFrom(const fs::path& directory, const fs::path& file) {
  return wholePath(file).lexically_relative(wholePath(directory)).generic_string();
}

/// Paths stand in the plan and in what workers are told, as text.
void requireText(const fs::path& path) {
  if (firstLineNotText(path.string()) != 0)
    throw InputError(inFile(printableLine(path.string())),
                     "its path is not UTF-8, expected folders whose names are");
}

std::string countText(double count) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << count;
  return text.str();
}

void refuseTooMany(const fs::path& file, double runs, bool allow_many) {
  const std::string found = file.string() + ": plans " + countText(runs) + " runs, expected at most ";
  if (runs > max_sweep_runs) throw InputError(found + countText(max_sweep_runs));
  if (runs > many_sweep_runs && !allow_many)
    throw InputError(found + countText(many_sweep_runs) + ", or --yes");
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

/// The name of the sweep whose plan is in the folder; a damaged plan is replaced as if it were `ours`.
std::string nameIn(const fs::path& folder, const std::string& ours) {
  try {
    return readManifest(folder).settings.name;
  } catch (const DamagedManifest&) {
    return ours;
  }
}

class Planner {
 public:
  Planner(fs::path file, fs::path folder, bool allow_many)
      : file_(std::move(file)), folder_(std::move(folder)) {
    requireText(wholePath(folder_));
    manifest_.settings = loadSweep(file_);
    base_file_ = (manifest_.settings.directory / manifest_.settings.base).lexically_normal();
    const CheckedScenario checked =
        checkScenario(base_file_, {manifest_.settings.pipelines, {}, true, false});
    base_ = checked.loaded;
    requireText(wholePath(base_.scenario.directory));
    const LoadedScenario all = parseScenario(base_.composed, base_file_);
    all_entries_ = all.scenario.pipelines;
    scenario_files_ = base_.inputs.size() - all.inputs.size();
    manifest_.scenario = base_.composed;
    manifest_.directory = nameFrom(folder_, base_.scenario.directory);
    for (const PipelineSettings& entry : base_.scenario.pipelines) manifest_.pipelines.push_back(entry.name);
    const double runs = SweepPoints::designed(manifest_.settings) *
                        static_cast<double>(manifest_.pipelines.size()) * manifest_.settings.repeats;
    refuseTooMany(file_, runs, allow_many);
    manifest_.points = SweepPoints(manifest_.settings);
    if (manifest_.points.size() == 0)
      throw InputError(inFile(file_), "exclude leaves no point, expected some");
    checkAxes();
    addCurves(checked);
    addEngines();
    addFit();
    for (const fs::path& input : all.inputs) addInput(input);
    if (!takeEarlierPlan()) checkPoints();
  }

  SweepManifest take() { return std::move(manifest_); }

 private:
  void addEngines() {
    std::set<std::string> precisions;
    for (const PipelineSettings& entry : base_.scenario.pipelines)
      precisions.insert(nameIn(catalog().precisions, entry.precision));
    const std::vector<std::string>& paths = manifest_.points.paths();
    if (std::any_of(paths.begin(), paths.end(),
                    [](const std::string& p) { return p.ends_with(".precision"); }))
      precisions = {"f32", "f64"};
    for (const std::string& precision : precisions)
      manifest_.engines[precision] = hashOf(engineProgram(precision));
  }

  void addCurves(const CheckedScenario& checked) {
    if (!manifest_.settings.curves) return;
    const RecordLayout layout = layoutOf(checked, checked.loaded.scenario.pipelines.front());
    manifest_.curves = curveQuantities(manifest_.settings.curves->quantities, layout,
                                       file_.string() + ": curves.quantities");
  }

  void addFit() {
    const std::optional<SweepFit>& fit = manifest_.settings.fit;
    if (!fit) return;
    const fs::path curve = (manifest_.settings.directory / fit->curve).lexically_normal();
    manifest_.measured = readTextFile(curve);
    if (const int line = firstLineNotText(manifest_.measured))
      throw InputError(inFile(curve, line), "binary data or not UTF-8, expected UTF-8 text");
    const std::vector<ForceSettings>& laws = base_.scenario.force;
    std::vector<std::string> names;
    for (const ForceSettings& law : laws) names.push_back(law.name);
    if (fit->law && std::find(names.begin(), names.end(), *fit->law) == names.end())
      throw InputError(inFile(file_), fmt::format("fit.law: no force law \"{}\"{}", *fit->law,
                                                  didYouMean(*fit->law, names)));
    SweepMisfit(*fit, names, curve);
  }

  void checkPoints() {
    const SweepPoints& points = manifest_.points;
    for (const std::size_t point : pointsToCheck(points)) {
      std::vector<Override> overrides;
      for (std::size_t a = 0; a < points.paths().size(); ++a)
        overrides.push_back({points.paths()[a], points.value(point, a)});
      try {
        checkPoint(loadScenario(base_file_, overrides));
      } catch (const InputError& error) {
        fail(error, overrides);
      }
    }
    if (curves_until_s_ && !manifest_.settings.curves->until_s)
      manifest_.settings.curves->until_s = curves_until_s_;
  }

  /// Refuses a point: with the line of the axis that is to blame, else with all its values.
  [[noreturn]] void fail(const InputError& error, const std::vector<Override>& overrides) const {
    for (const AxisGroup& group : manifest_.settings.axes)
      for (const SweepAxis& axis : group.axes)
        if (error.origin().kind == Origin::Kind::override && error.origin().path == axis.path)
          throw InputError(ofAxis(axis.path, file_.string(), axis.line), error.text());
    std::string values;
    for (const Override& override : overrides)
      values += (values.empty() ? "" : ", ") + override.path + "=" + override.value;
    throw InputError(inFile(file_), fmt::format("with {}: {}", values, error.what()));
  }

  /// A place of the scenario in one way of writing: items of lists by their number.
  std::vector<std::string> placeOf(const std::string& path) const {
    YamlNode root = parseYaml(base_.composed, inFile(base_file_, 1));
    const YamlNode* node = &root;
    std::vector<std::string> place;
    for (const std::string& part : splitPath(path)) {
      place.push_back(part);
      if (node && node->kind == YamlNode::Kind::list) {
        for (std::size_t i = 0; i < node->children.size(); ++i)
          if (itemName(node->children[i]) == part) place.back() = std::to_string(i);
        const std::optional<int> index = toInt(place.back());
        const bool known = index && *index >= 0 && static_cast<std::size_t>(*index) < node->children.size();
        node = known ? &node->children[static_cast<std::size_t>(*index)] : nullptr;
      } else if (node) {
        node = node->find(part);
      }
    }
    return place;
  }

  /// No axis may lie within another one, nor say what is run.
  void checkAxes() const {
    std::vector<std::pair<const SweepAxis*, std::vector<std::string>>> seen;
    for (const AxisGroup& group : manifest_.settings.axes) {
      for (const SweepAxis& axis : group.axes) {
        const auto refuse = [&](const std::string& what) {
          throw InputError(ofAxis(axis.path, file_.string(), axis.line), what);
        };
        const std::vector<std::string> place = placeOf(axis.path);
        const std::string& first = place.front();
        if (first == "pipelines") checkEntryAxis(place, refuse);
        if (first == "name" || first == "format" || first == "base" || first == "description" ||
            first == "expect")
          refuse("changes no simulation, expected a place that does");
        for (const auto& [other, of_other] : seen) {
          const std::size_t common = std::min(place.size(), of_other.size());
          if (std::equal(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(common),
                         of_other.begin()))
            refuse(fmt::format("is the place of axis {} or within it, expected places apart", other->path));
        }
        seen.emplace_back(&axis, place);
      }
    }
  }

  template <class Refuse>
  void checkEntryAxis(const std::vector<std::string>& place, const Refuse& refuse) const {
    if (place.size() < 3 || place.back() == "name")
      refuse("changes which pipelines there are, expected a setting of one");
    const std::optional<int> index = toInt(place[1]);  // of a known entry
    if (!index || *index < 0 || static_cast<std::size_t>(*index) >= all_entries_.size()) return;
    const std::string& name = all_entries_[static_cast<std::size_t>(*index)].name;
    const std::vector<std::string>& runs = manifest_.pipelines;
    if (std::find(runs.begin(), runs.end(), name) == runs.end())
      refuse(fmt::format("the sweep does not run {}, expected a setting of a pipeline that it runs", name));
  }

  /// Its hash goes into the plan; returns its name there.
  std::string addInput(const fs::path& input) {
    std::string name = nameFrom(base_.scenario.directory, input);
    requireText(name);
    if (!manifest_.inputs.contains(name)) manifest_.inputs[name] = hashOf(input);
    return name;
  }

  void checkPoint(LoadedScenario loaded) {
    loaded.inputs.erase(loaded.inputs.begin(),  // the scenario's own files are in the composed text
                        loaded.inputs.begin() + static_cast<std::ptrdiff_t>(scenario_files_));
    for (const fs::path& input : loaded.inputs) {
      const bool known = manifest_.inputs.contains(nameFrom(base_.scenario.directory, input));
      const std::string name = addInput(input);
      if (!known) manifest_.axis_inputs.insert(name);
    }
    std::vector<std::string> names;
    for (const ForceSettings& law : loaded.scenario.force) names.push_back(law.name);
    std::vector<std::string> base_names;
    for (const ForceSettings& law : base_.scenario.force) base_names.push_back(law.name);
    if (names != base_names)
      throw InputError(
          fmt::format("the force laws have other names or another order than in {}, expected the same laws "
                      "in every point",
                      base_file_.string()));
    const CheckedScenario checked =
        checkLoaded(base_file_, std::move(loaded), {manifest_.settings.pipelines, {}, true, false});
    const std::optional<SweepCurves>& curves = manifest_.settings.curves;
    if (!curves) return;
    const auto& quantities = curves->quantities;
    const int every = stepsPerRow(checked.loaded.scenario.record, checked.loaded.scenario.measure);
    if (every > 1 && std::find(quantities.begin(), quantities.end(), "indentation") != quantities.end())
      throw InputError(
          fmt::format("the record has a row every {} steps, expected every step for the curve "
                      "`indentation`, which begins with the first in contact",
                      every));
    curves_until_s_ = std::max({checked.duration_s, curves->every_s, curves_until_s_.value_or(0)});
  }

  /// What was checked for the folder before is not checked again: a shard a process would do it often.
  bool takeEarlierPlan() {
    std::error_code ignored;
    if (!fs::exists(manifestFile(folder_), ignored)) return false;
    try {
      SweepManifest earlier = readManifest(folder_);
      if (earlier.settings.source != manifest_.settings.source || earlier.scenario != manifest_.scenario ||
          earlier.directory != manifest_.directory || earlier.engines != manifest_.engines ||
          earlier.pipelines != manifest_.pipelines || earlier.measured != manifest_.measured)
        return false;
      refuseOtherPlan(earlier, folder_);
      manifest_ = std::move(earlier);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  fs::path file_, folder_;
  LoadedScenario base_;
  SweepManifest manifest_;
  fs::path base_file_;
  std::size_t scenario_files_ = 0;  ///< the base and its own bases, first among the inputs
  std::vector<PipelineSettings> all_entries_;
  std::optional<double> curves_until_s_;  ///< the longest run that was checked
};

}  // namespace

SweepManifest planSweep(const fs::path& file, const fs::path& folder, bool allow_many) {
  return Planner(file, folder, allow_many).take();
}

void refuseOtherFolder(const SweepManifest& manifest, const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(manifestFile(folder), ignored)) {
    const std::string name = nameIn(folder, manifest.settings.name);
    if (name != manifest.settings.name)
      throw InputError(inFile(folder),
                       fmt::format("holds the sweep \"{}\", expected another folder for \"{}\"", name,
                                   manifest.settings.name));
  } else if (!isFree(folder)) {
    throw InputError(inFile(folder), "is no folder of a sweep, expected a new name or an empty folder");
  }
}

void putManifest(const SweepManifest& manifest, const fs::path& folder) {
  refuseOtherFolder(manifest, folder);
  const JournalWriter place(journalFolder(folder));  // for its folder alone
  const fs::path made = manifestFile(place.work());
  try {
    TemporaryFile file(made);
    file.write(manifestText(manifest));
    file.commit();
  } catch (const RunError& failure) {
    throw RunError(manifestFile(folder).string() + ": " + failure.what());
  }
  std::error_code error;
  fs::rename(made, manifestFile(folder), error);
  if (error) throw RunError(manifestFile(folder).string() + ": cannot be written: " + error.message());
}

void refuseOtherPlan(const SweepManifest& manifest, const fs::path& folder) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(
        inFile(folder),
        fmt::format("was planned with another {}, expected its sweep file to plan it again", what));
  };
  requireText(wholePath(folder / manifest.directory));
  for (const auto& [precision, hash] : manifest.engines) {
    const fs::path program = engineProgram(precision);
    if (hashOf(program) != hash) refuse(program.filename().string());
  }
  for (const auto& [name, hash] : manifest.inputs)
    if (hashOf(fs::weakly_canonical(folder) / manifest.directory / name) != hash) refuse(name);
}

}  // namespace fissure
