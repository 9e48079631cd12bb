#include "study/tradeoff_sweeps.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "files/write_file.h"
#include "study/tradeoff_recommend.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// What errors need of the scenario.
void refuseUnrecorded(const TradeoffStudy& study, const Scenario& scenario) {
  const auto refuse = [&](const std::string& what) { throw InputError(inFile(study.file), what); };
  std::vector<std::string> laws;
  for (const ForceSettings& law : scenario.force) laws.push_back(law.name);
  for (const StudyError& error : study.errors) {
    if (error.quantity == ErrorQuantity::shape && !scenario.record.snapshots_every_s)
      refuse("errors: shape needs snapshots, expected record.snapshots_every_s in " + study.base);
    if (error.quantity != ErrorQuantity::force) continue;
    if (laws.empty()) refuse("errors: force needs a law, expected one in " + study.base);
    if (error.law && std::find(laws.begin(), laws.end(), *error.law) == laws.end())
      refuse(fmt::format("errors: no force law \"{}\"{}", *error.law, didYouMean(*error.law, laws)));
  }
}

/// `folder`, if there is none or it is one.
fs::path usable(fs::path folder) {
  std::error_code ignored;
  for (fs::path way = folder; !way.empty(); way = way.has_relative_path() ? way.parent_path() : fs::path())
    if (fs::exists(way, ignored) && !fs::is_directory(way, ignored))
      throw InputError("-o " + folder.string() + ": " + way.string() +
                       " is a file, expected a folder or a new name");
  return folder;
}

TradeoffStudy checked(TradeoffStudy study) {
  refuseUnrecorded(study, loadScenario(study.directory / study.base).scenario);
  return study;
}

/// The first folder on the way to `folder` that is not there; empty where all are.
fs::path topmostNew(const fs::path& folder) {
  std::error_code ignored;
  fs::path way;
  for (const fs::path& part : folder) {
    way /= part;
    if (!fs::exists(way, ignored)) return way;
  }
  return {};
}

bool hasShell(const Scenario& scenario) {
  return std::any_of(scenario.bodies.begin(), scenario.bodies.end(),
                     [](const BodySettings& body) { return body.model == BodyModel::shell; });
}

}  // namespace

StudySweeps::StudySweeps(TradeoffStudy study, fs::path folder)
    : study_(checked(std::move(study))),
      folder_(usable(std::move(folder))),
      new_folder_{topmostNew(folder_)},
      settings_(study_, "settings", folder_, base(), study_.pipelines, settingsOf(study_), study_.repeats),
      ladder_(study_, "ladder", folder_, base(), referencePipelines(), rungsOf(study_), 1) {
  replaceFile(folder_ / "study.yaml", study_.source);
  new_folder_.top.clear();
}

StudySweeps::NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!top.empty()) fs::remove_all(top, ignored);
}

fs::path StudySweeps::base() const {
  return study_.directory / study_.base;
}

std::vector<std::string> StudySweeps::referencePipelines() const {
  if (study_.reference.pipeline) return {*study_.reference.pipeline};
  return study_.pipelines;
}

TradeoffResult StudySweeps::judge(CostMeasure cost) const {
  TradeoffResult result = judgeStudy(study_, settings_, ladder_, cost);
  if (!hasShell(settings_.plan().base().scenario)) return result;
  for (JudgedReference& reference : result.references)
    if (study_.errors[reference.error].quantity == ErrorQuantity::reaction &&
        !reference.refinement.refused.empty())
      reference.refinement.refused += "; a shell of springs stiffens as 1/dt^2, its reaction never converges";
  return result;
}

void StudySweeps::writeScenario(TradeoffAnswer& answer, const TradeoffResult& result,
                                CostMeasure cost) const {
  const JudgedSetting& setting = result.settings[answer.choice.best.value()];
  answer.file = folder_ / (answer.wish.name + ".yaml");
  std::vector<std::string> comment = {
      fmt::format("The setting that the study {} found for: {}.", study_.name, answer.wish.text()),
      fmt::format("{}: {:.4g} us for a simulated millisecond on the machine of the study.",
                  settingText(setting, result), costOf(setting, cost).median)};
  replaceFile(answer.file,
              recommendedText(base(), answer.file, setting.pipeline, overridesOf(setting, result), comment));
}

StudyPart StudySweeps::planAgain(const TradeoffAnswer& answer, const TradeoffResult& result) const {
  const JudgedSetting& setting = result.settings[answer.choice.best.value()];
  const std::string name = answer.wish.name + "_again";
  std::error_code ignored;
  fs::remove_all(folder_ / name, ignored);
  const LoadedScenario loaded = loadScenario(answer.file);
  const StudyPoints point{{"time.step_s"}, {{formatReal(loaded.scenario.time.step_s)}}};
  return {study_, name, folder_, answer.file, {setting.pipeline}, point, study_.repeats};
}

void StudySweeps::judgeAgain(TradeoffAnswer& answer, const StudyPart& again, const TradeoffResult& result,
                             CostMeasure cost) const {
  FinestRungs finest;
  judgeLadder(study_, ladder_.runs(), finest);
  const JudgedSetting& setting = result.settings[answer.choice.best.value()];
  answer.again = judgeSetting(study_, again.runs().front(), setting.values, result, finest);
  answer.holds = fulfils(*answer.again, answer.wish, study_, result, cost);
}

}  // namespace fissure
