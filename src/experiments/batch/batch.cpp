#include "batch/batch.h"

#include <algorithm>

namespace fissure {

Batch::Batch(std::vector<Experiment>& experiments, const std::string& command_line, ProgressDisplay& display)
    : experiments_(experiments), command_line_(command_line), display_(display) {
  for (std::size_t e = 0; e < experiments.size(); ++e) {
    const CheckedScenario& checked = experiments[e].checked();
    const std::string prefix = experiments.size() > 1 ? checked.loaded.scenario.name + "/" : "";
    std::size_t index = 0;
    for (WorkerTask& task : experiments[e].tasks()) {
      progress_.push_back({prefix + checked.loaded.scenario.pipelines[index].name,
                           RunProgress::Phase::waiting,
                           {0, checked.steps}});
      owners_.emplace_back(e, index++);
      tasks_.push_back(std::move(task));
    }
  }
}

void Batch::run(int slots, Interrupt& interrupt) {
  WorkerPool(slots, interrupt).run(tasks_, *this);
  display_.clear();
}

BatchOutcome Batch::outcome() const {
  BatchOutcome outcome = BatchOutcome::good;
  for (const Experiment& experiment : experiments_) {
    for (const CheckedExpectation& checked : experiment.expectations())
      if (!checked.holds) outcome = std::max(outcome, BatchOutcome::unexpected);
    if (!experiment.error().empty()) outcome = BatchOutcome::failed;
    for (const PartResult& result : experiment.results()) {
      if (result.status.end == RunEnd::interrupted) return BatchOutcome::interrupted;
      if (result.status.end != RunEnd::ok) outcome = BatchOutcome::failed;
    }
  }
  return outcome;
}

void Batch::started(std::size_t task) {
  progress_[task].phase = RunProgress::Phase::running;
  experiments_[owners_[task].first].noteStart();
}

void Batch::progressed(std::size_t task, const Progress& progress) {
  progress_[task].progress = progress;
}

void Batch::finished(std::size_t task, const RunStatus& status) {
  progress_[task].phase = RunProgress::Phase::ended;
  const auto [owner, index] = owners_[task];
  Experiment& experiment = experiments_[owner];
  experiment.noteEnd(index, status);
  if (experiment.ended()) experiment.close(command_line_);
}

}  // namespace fissure
