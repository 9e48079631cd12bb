#include "study/tradeoff_part.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "files/write_file.h"
#include "study/tradeoff_file.h"
#include "sweep/sweep_planning.h"
#include "sweep/sweep_results.h"
#include "sweep/sweep_state.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// The line of an axis in the study's file; 0 where it has none.
int lineOf(const TradeoffStudy& study, const std::string& path) {
  std::vector<AxisGroup> groups = study.axes;
  groups.push_back(study.reference.ladder);
  for (const AxisGroup& group : groups)
    for (const SweepAxis& axis : group.axes)
      if (axis.path == path) return axis.line;
  return 0;
}

/// The same error about the study's file, where it is about the sweep that was made of it.
InputError aboutStudy(const TradeoffStudy& study, const fs::path& sweep, const InputError& error) {
  const Origin& origin = error.origin();
  if (origin.kind == Origin::Kind::axis)
    return {ofAxis(origin.path, study.file.string(), lineOf(study, origin.path)), error.text()};
  if (origin.file == sweep.string()) return {inFile(study.file), error.text()};
  return error;
}

std::vector<std::size_t> allOf(const SweepPlan& plan) {
  std::vector<std::size_t> tasks(plan.tasks().size());
  for (std::size_t i = 0; i < tasks.size(); ++i) tasks[i] = i;
  return tasks;
}

}  // namespace

StudyPart::StudyPart(const TradeoffStudy& study, const std::string& name, const fs::path& folder,
                     const fs::path& base, const std::vector<std::string>& pipelines,
                     const StudyPoints& points, int repeats)
    : name_(name), folder_(folder / name) {
  const fs::path file = folder / (name + ".yaml.part");  // until the plan holds
  std::error_code error, ignored;
  fs::create_directories(folder, error);
  if (error) throw RunError(folder.string() + ": cannot be made: " + error.message());
  const std::string from = fs::weakly_canonical(fs::current_path() / base)
                               .lexically_relative(fs::weakly_canonical(fs::current_path() / folder))
                               .generic_string();
  try {
    writeFile(file, sweepTextOf(study, study.name + "_" + name, from, pipelines, points, repeats));
    SweepManifest manifest = planSweep(file, folder_, true);
    putManifest(manifest, folder_);
    plan_ = std::make_unique<SweepPlan>(std::move(manifest), folder_);
  } catch (const InputError& refused) {
    fs::remove(file, ignored);
    throw aboutStudy(study, file, refused);
  } catch (const RunError&) {
    fs::remove(file, ignored);
    throw;
  }
  fs::rename(file, folder / (name + ".yaml"), error);
  if (!error) return;
  fs::remove(file, ignored);
  throw RunError(file.string() + ": cannot be renamed: " + error.message());
}

std::vector<std::size_t> StudyPart::unfinished(std::size_t index, std::size_t count) const {
  SweepState state(*plan_, folder_);
  forgetLostResults(state, folder_, allOf(*plan_), ResultCheck::contents);
  std::vector<std::size_t> tasks = state.unfinished();
  std::erase_if(tasks, [&](std::size_t task) { return plan_->shardOf(task, count) != index - 1; });
  const auto turn = [&](std::size_t task) {
    const int repeat = plan_->tasks()[task].repeat;
    const auto place = static_cast<long long>(task);
    return std::pair(repeat, repeat % 2 == 0 ? place : -place);
  };
  std::sort(tasks.begin(), tasks.end(), [&](std::size_t a, std::size_t b) { return turn(a) < turn(b); });
  return tasks;
}

SessionCounts StudyPart::run(const std::vector<std::size_t>& tasks, const Settings& settings,
                             Interrupt& interrupt, ProgressDisplay& display) const {
  if (tasks.empty()) return {};
  SweepSession session(*plan_, folder_, tasks, {settings.slots, tasks.size(), false, settings.command_line},
                       display);
  session.run(interrupt);
  return session.counts();
}

std::vector<TradeoffRun> StudyPart::runs() const {
  SweepState state(*plan_, folder_);
  forgetLostResults(state, folder_, allOf(*plan_), ResultCheck::size);
  std::vector<TradeoffRun> runs;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> places;  // [point, entry] index in runs
  std::set<std::size_t> seen;                                         // tasks
  for (std::size_t i = 0; i < plan_->runs(); ++i) {
    const PlannedRun planned = plan_->run(i);
    if (!seen.insert(planned.task).second) continue;
    const auto [place, is_new] = places.try_emplace({planned.point, planned.entry}, runs.size());
    if (is_new) {
      TradeoffRun& run = runs.emplace_back();
      run.point = planned.point;
      run.pipeline = plan_->manifest().pipelines[planned.entry];
      run.status.end = RunEnd::ok;
    }
    TradeoffRun& run = runs[place->second];
    const SweepState::Task& task = state.task(planned.task);
    if (task.status.end != RunEnd::ok && run.status.end == RunEnd::ok) run.status = task.status;
    if (task.status.end != RunEnd::ok) continue;
    if (run.file.empty() && !task.file.empty()) run.file = folder_ / task.file;
    for (const auto& [name, value] : state.head(planned.task).record.timing)
      run.timing[name.substr(name.find('/') + 1)].push_back(value);
  }
  return runs;
}

}  // namespace fissure
