#include "batch/experiment.h"

#include <algorithm>

#include "base/error.h"
#include "batch/assemble_apart.h"
#include "batch/engine_program.h"
#include "files/write_file.h"
#include "process/apart.h"
#include "store/salvage.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

void refuseInputsAsOutput(const LoadedScenario& loaded, const fs::path& output) {
  for (const fs::path& input : loaded.inputs) {
    std::error_code missing;
    if (fs::equivalent(input, output, missing))
      throw InputError(inFile(output), "is an input of the scenario, expected another name for the result");
  }
}

/// Where the part of a run into `output` is kept when the run does not end.
fs::path keptPart(const fs::path& output, const std::string& run) {
  fs::path kept = output;
  kept += "." + run + ".part";
  return kept;
}

/// A part kept by an earlier attempt may hold more than this one will.
void refuseKeptParts(const Scenario& scenario, const fs::path& output) {
  for (const PipelineSettings& pipeline : scenario.pipelines) {
    const fs::path kept = keptPart(output, pipeline.name);
    if (fs::exists(kept))
      throw InputError(inFile(kept), "kept by an earlier run, salvage it, remove it or use --force");
  }
}

/// `text` without the names of `folder` in it: what a worker says is stored with the result, which must not
/// depend on where it was made.
std::string without(std::string text, const fs::path& folder) {
  const std::string name = (folder / "").string();
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;) text.erase(at, name.size());
  return text;
}

/// What a worker that ended well says about its run.
RunStatus statusIn(const fs::path& part, const std::string& name) {
  try {
    tryReadingOwn(part, [&] { inspectPart(part); });
    for (const PipelineResult& result : readResultInfo(part).pipelines)
      if (result.name == name && (result.status.end == RunEnd::ok || result.status.end == RunEnd::non_finite))
        return result.status;
  } catch (const std::runtime_error& error) {
    return {RunEnd::failed, std::string("the worker left no whole part: ") + error.what()};
  }
  return {RunEnd::failed, "the worker ended without finishing its part"};
}

}  // namespace

Experiment::Experiment(CheckedScenario checked, const fs::path& output, const OutputRules& rules)
    : checked_(std::move(checked)),
      output_(output),
      keep_parts_(rules.keep_parts),
      open_(checked_.loaded.scenario.pipelines.size()) {
  checked_.prepared = {};  // every worker reads the files itself
  refuseInputsAsOutput(checked_.loaded, output);
  if (keep_parts_ && !rules.replace) refuseKeptParts(checked_.loaded.scenario, output);
  input_hashes_ = inputHashes(checked_.loaded);
  slot_ = std::make_unique<OutputSlot>(output, rules.replace);
  writeFile(resolvedFile(), checked_.loaded.resolved);
  for (const PipelineSettings& pipeline : checked_.loaded.scenario.pipelines)
    results_.push_back({pipeline, {}, {}});
}

fs::path Experiment::partOf(std::size_t index) const {
  return slot_->parts() / (std::to_string(index) + ".part");
}

std::vector<WorkerTask> Experiment::tasks() const {
  std::vector<WorkerTask> tasks;
  for (std::size_t i = 0; i < results_.size(); ++i)
    tasks.push_back(engineTask(
        {resolvedFile(), fs::absolute(checked_.loaded.scenario.directory), results_[i].pipeline, partOf(i)}));
  return tasks;
}

void Experiment::noteStart() {
  if (start_) return;
  start_ = std::chrono::steady_clock::now();
  times_.started = std::chrono::system_clock::now();
}

void Experiment::noteEnd(std::size_t index, const RunStatus& status) {
  PartResult& result = results_[index];
  result.status = status.end == RunEnd::ok ? statusIn(partOf(index), result.pipeline.name) : status;
  const fs::path folder = fs::absolute(checked_.loaded.scenario.directory);
  result.status.detail = without(without(result.status.detail, slot_->parts()), folder);
  if (result.status.end == RunEnd::ok || result.status.end == RunEnd::non_finite) {
    result.part = partOf(index);
  } else if (!keep_parts_) {
    std::error_code ignored;
    fs::remove(partOf(index), ignored);  // runs are deterministic: half of one is worth no disk space
  }
  --open_;
}

bool Experiment::interrupted() const {
  return std::any_of(results_.begin(), results_.end(),
                     [](const PartResult& result) { return result.status.end == RunEnd::interrupted; });
}

/// Workers read logs for themselves: when one changed meanwhile, the runs may not have had the same motion.
void Experiment::refuseChangedInputs() {
  std::string now;
  try {
    now = inputHashes(checked_.loaded);
  } catch (const RunError&) {
    now = "gone";
  }
  if (now == input_hashes_) return;
  for (PartResult& result : results_) {
    if (result.status.end == RunEnd::ok)
      result.status = {RunEnd::failed,
                       "an input file of the scenario was changed or removed while the runs went on"};
  }
}

bool Experiment::worthKeeping() const {
  const auto finished = [](const PartResult& result) { return result.part.has_value(); };
  return !interrupted() || std::any_of(results_.begin(), results_.end(), finished);
}

void Experiment::close(const std::string& command_line) {
  noteStart();  // where no worker could be started
  times_.ended = std::chrono::system_clock::now();
  times_.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - *start_).count();
  refuseChangedInputs();
  const fs::path name = output_;
  if (worthKeeping()) writeResult(command_line);
  for (std::size_t i = 0; i < results_.size(); ++i) keepPart(i, name);
  slot_.reset();
}

void Experiment::writeResult(const std::string& command_line) {
  if (interrupted() && fs::exists(output_)) output_ = slot_->interruptedOutput();
  try {
    assembleApart(output_, checked_.loaded,
                  collectProvenance(checked_.loaded, input_hashes_, command_line, times_), results_,
                  slot_->parts());
    info_ = readResultInfo(output_);
    noteUnreadableParts();
    if (!interrupted()) expectations_ = checkExpectations(checked_.loaded.scenario.expect, info_->pipelines);
  } catch (const std::runtime_error& error) {
    error_ = error.what();
  }
}

/// That a part could not be copied is known to the result alone.
void Experiment::noteUnreadableParts() {
  for (PartResult& result : results_)
    for (const PipelineResult& written : info_->pipelines) {
      if (written.name != result.pipeline.name || written.status.detail == result.status.detail) continue;
      result.status = written.status;
      result.part.reset();
    }
}

/// Keeps the part of a run that is not in the result; one that is needs none, nor what an earlier attempt
/// kept.
void Experiment::keepPart(std::size_t index, const fs::path& name) {
  const fs::path kept = keptPart(name, results_[index].pipeline.name);
  std::error_code error;
  if (info_ && results_[index].part) {
    fs::remove(kept, error);
    return;
  }
  if (keep_parts_) keepUnder(kept, index);
}

void Experiment::keepUnder(const fs::path& kept, std::size_t index) {
  const fs::path part = partOf(index);
  try {
    if (!fs::exists(part)) throw RunError("nothing was written");
    tryReadingOwn(part, [&] { inspectPart(part); });
    inspectPart(part);
    fs::rename(part, kept);
    kept_parts_.push_back(kept);
  } catch (const fs::filesystem_error& error) {
    unkept_parts_.push_back(results_[index].pipeline.name + ": " + error.code().message());
  } catch (const InputError& error) {
    unkept_parts_.push_back(results_[index].pipeline.name + ": " +
                            (error.isAbout(part) ? error.text() : error.what()));
  } catch (const std::runtime_error& error) {
    unkept_parts_.push_back(results_[index].pipeline.name + ": " + error.what());
  }
}

}  // namespace fissure
