#include "sweep/sweep_session.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "batch/assemble_apart.h"
#include "batch/engine_program.h"
#include "batch/provenance.h"
#include "files/input_file.h"
#include "files/write_file.h"
#include "sweep/sweep_planning.h"
#include "sweep/sweep_state.h"
#include "text/scalars.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr double sync_every_s = 2;

std::string bytesOf(const fs::path& file) try {
  return readInputFile(file, "a record");
} catch (const InputError&) {
  throw RunError("the worker left no record");
}

}  // namespace

TaskOrder orderOf(const SweepPlan& plan, const SweepTask& task) {
  TaskOrder order{plan.manifest().settings.name,         plan.manifest().scenario,
                  fs::absolute(plan.directory()),        plan.overrides(task),
                  plan.manifest().pipelines[task.entry], {},
                  plan.manifest().settings.curves,       plan.manifest().settings.keep != SweepKeep::series};
  if (task.laws.size() > 1)
    for (const std::size_t point : task.laws) order.laws.push_back(plan.lawsAt(point));
  return order;
}

SweepSession::SweepSession(const SweepPlan& plan, const fs::path& folder, std::vector<std::size_t> tasks,
                           Settings settings, ProgressDisplay& display)
    : plan_(plan),
      folder_(folder),
      tasks_(std::move(tasks)),
      settings_(std::move(settings)),
      display_(display),
      journal_(journalFolder(folder)) {
  std::error_code error;
  if (plan.keepsResults()) fs::create_directory(resultFolder(folder), error);
  if (error) throw RunError(folder.string() + ": cannot be written: " + error.message());
  for (const auto& [name, hash] : plan.manifest().inputs)
    inputs_.emplace_back(plan.directory() / name, stampOf(plan.directory() / name));
  for (const auto& [precision, hash] : plan.manifest().engines)
    inputs_.emplace_back(engineProgram(precision), stampOf(engineProgram(precision)));
  refuseOtherPlan(plan.manifest(), folder);  // since it was planned; from here on the stamps tell
}

fs::path SweepSession::work(std::size_t task, const char* ending) const {
  return fs::absolute(journal_.work() / (std::to_string(task) + ending));
}

void SweepSession::run(Interrupt& interrupt) {
  WorkerPool(settings_.slots, interrupt)
      .run(
          tasks_.size(), [this](std::size_t task) { return workerTask(task); }, *this);
  journal_.sync(0);
  display_.clear();
}

WorkerTask SweepSession::workerTask(std::size_t task) const {
  const SweepTask& of = plan_.tasks()[tasks_[task]];
  const SweepLimits& limits = plan_.manifest().settings.limits;
  const fs::path order = work(task, ".order");
  writeFile(order, orderText(orderOf(plan_, of)));
  WorkerTask worker{engineProgram(plan_.precision(of)),
                    {"--order", order.string(), "--record", work(task, ".record").string()},
                    limits.time_s.value_or(plan_.entry(of.entry).time_limit_s),
                    limits.memory_mib.value_or(0),
                    journal_.work()};
  if (plan_.keepsResults()) {
    worker.arguments.emplace_back("--part");
    worker.arguments.push_back(work(task, ".part").string());
  }
  return worker;
}

void SweepSession::started(std::size_t task) {
  running_[task] = {Clock::now(), {}};
}

void SweepSession::progressed(std::size_t task, const Progress& progress) {
  running_[task].progress = progress;
}

TaskRecord SweepSession::recordOf(std::size_t task, const RunStatus& status) const {
  TaskRecord record;
  record.status = status;
  if (status.end == RunEnd::ok) {
    try {
      record = decodeRecord(bytesOf(work(task, ".record")));
    } catch (const RunError& error) {
      record.status = {RunEnd::failed, error.what()};
    }
    if (record.finished() && plan_.keepsResults()) keepResult(task, record);
  }
  record.recorded_s =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  record.task = plan_.tasks()[tasks_[task]].id;
  const auto running = running_.find(task);
  if (running != running_.end())
    record.timing["timing/worker_wall_s"] =
        std::chrono::duration<double>(Clock::now() - running->second.start).count();
  std::string& detail = record.status.detail;
  const auto& memory_mib = plan_.manifest().settings.limits.memory_mib;
  if (memory_mib && (status.end == RunEnd::crashed || status.end == RunEnd::failed))
    detail += (detail.empty() ? "" : "; ") + std::string("its memory is limited to ") +
              formatReal(*memory_mib) + " MiB";
  for (const std::string& folder :
       {(fs::absolute(journal_.work()) / "").string(), (fs::absolute(plan_.directory()) / "").string()})
    for (std::size_t at = 0; (at = detail.find(folder, at)) != std::string::npos;)
      detail.erase(at, folder.size());
  return record;
}

/// The result file of one simulation, as `fissure run` would write it.
void SweepSession::keepResult(std::size_t task, TaskRecord& record) const {
  const SweepTask& of = plan_.tasks()[tasks_[task]];
  const std::string name = "runs/" + of.id + ".h5";
  LoadedScenario loaded = parseScenario(
      plan_.manifest().scenario, plan_.directory() / plan_.manifest().settings.name, plan_.overrides(of));
  const std::string& entry = plan_.manifest().pipelines[of.entry];
  std::erase_if(loaded.scenario.pipelines,
                [&](const PipelineSettings& other) { return other.name != entry; });
  loaded.scenario.expect.clear();
  if (plan_.manifest().settings.keep == SweepKeep::series) loaded.scenario.record.frames.reset();
  loaded.scenario.record.force_inputs |= of.laws.size() > 1;
  loaded.resolved = toYaml(loaded.scenario);
  RunTimes times;
  times.started = times.ended = std::chrono::system_clock::now();
  times.wall_s = std::chrono::duration<double>(Clock::now() - running_.at(task).start).count();
  times.started -= std::chrono::duration_cast<std::chrono::system_clock::duration>(
      std::chrono::duration<double>(times.wall_s));
  std::vector<PartResult> parts = {{loaded.scenario.pipelines.front(), work(task, ".part"), record.status}};
  const fs::path made = work(task, ".h5");
  assembleApart(made, loaded, collectProvenance(loaded, inputHashes(loaded), settings_.command_line, times),
                parts, journal_.work());
  if (!parts.front().part) {  // somebody damaged it
    record = {};
    record.status = parts.front().status;
    return;
  }
  fs::rename(made, folder_ / name);
  const FileStamp stamp = stampOf(folder_ / name);
  record.file = name;
  record.file_bytes = stamp.bytes;
  record.file_time = stamp.time;
}

/// Workers read meshes and logs for themselves: what runs after one changed would be another sweep.
void SweepSession::refuseChangedInputs() const {
  for (const auto& [file, stamp] : inputs_)
    if (stampOf(file) != stamp)
      throw RunError(file.string() + ": changed while the sweep ran; run it again to plan it anew");
}

void SweepSession::finished(std::size_t task, const RunStatus& status) {
  if (status.end == RunEnd::interrupted) {
    ++counts_.interrupted;
  } else {
    refuseChangedInputs();
    const TaskRecord record = recordOf(task, status);
    journal_.append(encodeRecord(record));
    journal_.sync(sync_every_s);
    const bool ok = record.status.end == RunEnd::ok;
    ++(ok ? counts_.ok : counts_.failed);
    if (record.finished() || task < settings_.untried) ++counts_.advanced;
    if (!ok && first_failure_.empty())
      first_failure_ = fmt::format("{}: {}{}", record.task, nameOf(record.status.end),
                                   record.status.detail.empty() ? "" : " (" + record.status.detail + ")");
  }
  running_.erase(task);
  std::error_code ignored;
  for (const char* ending : {".order", ".record", ".part"}) fs::remove(work(task, ending), ignored);
}

/// Not recorded, as it is no finding about the simulation: a study would take it for one.
void SweepSession::hindered(std::size_t, const std::string& reason) {
  throw RunError(reason);
}

void SweepSession::woke() {
  display_.show([this](double elapsed_s) { return progressLine(elapsed_s); });
}

std::string SweepSession::progressLine(double elapsed_s) const {
  const std::size_t ended = counts_.ok + counts_.failed;
  double done = static_cast<double>(ended);
  for (const auto& [task, running] : running_)
    if (running.progress.steps > 0)
      done += static_cast<double>(running.progress.step) / static_cast<double>(running.progress.steps);
  std::ostringstream line;
  line << ended << "/" << tasks_.size() << " simulations";
  if (counts_.failed > 0) line << ", " << counts_.failed << " failed";
  if (elapsed_s <= 0 || done <= 0) return line.str();
  line.precision(3);
  line << ", " << done / elapsed_s << "/s, "
       << durationText((static_cast<double>(tasks_.size()) - done) * elapsed_s / done) << " left";
  return line.str();
}

}  // namespace fissure
