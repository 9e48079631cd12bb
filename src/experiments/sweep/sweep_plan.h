#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenario/load.h"
#include "sweep/sweep_manifest.h"

namespace fissure {

/// One simulation of a sweep, in one worker process.
struct SweepTask {
  /// Hash of all that its numbers depend on: scenario, overrides, laws, entry, repeat, input files, worker
  /// program; 16 hexadecimal digits. The same in every sweep, shard and session.
  std::string id;
  std::size_t entry = 0;  ///< of the manifest's pipelines
  int repeat = 0;
  std::size_t point = 0;          ///< a point with its physics
  std::vector<std::size_t> laws;  ///< a point for each set of force laws; one: they are the scenario's own
};

/// One row of the table: a point through a pipeline entry.
struct PlannedRun {
  std::size_t point = 0;
  std::size_t entry = 0;
  int repeat = 0;
  std::size_t task = 0;
  std::size_t law = 0;  ///< of the task's
};

/// What a manifest comes to. Points that differ only in coefficients of force laws share a simulation, and so
/// do points that differ in what an entry does not read: the settings of other entries. Runs are in the order
/// point (slowest), entry, repeat; tasks in that of their first run.
class SweepPlan {
 public:
  /// Throws InputError when the manifest's scenario cannot be read or a coefficient is no number.
  /// `folder`: the sweep's, where the manifest's directory starts.
  SweepPlan(SweepManifest manifest, const std::filesystem::path& folder);

  const SweepManifest& manifest() const { return manifest_; }
  /// Its inputs need not be there.
  const LoadedScenario& base() const { return base_; }
  /// Where relative file names of the scenario start.
  const std::filesystem::path& directory() const { return base_.scenario.directory; }

  std::size_t runs() const { return run_sources_.size(); }
  PlannedRun run(std::size_t index) const;
  const std::vector<SweepTask>& tasks() const { return tasks_; }

  /// Whether an axis only changes a coefficient of a force law, which moves nothing.
  bool isLawAxis(std::size_t axis) const { return axes_[axis].law; }
  /// What the scenario of a task has else than the base: the values of axes that its entry reads, but for
  /// those of law axes where the task has several sets of laws.
  std::vector<Override> overrides(const SweepTask& task) const;
  /// All values of a point.
  std::vector<Override> overridesAt(std::size_t point) const;
  /// The force laws of a point, in the scenario's order.
  std::vector<ForceSettings> lawsAt(std::size_t point) const;
  const PipelineSettings& entry(std::size_t index) const;
  /// Which of `shards`, from 0, a task belongs to: the same in every session of this plan.
  std::size_t shardOf(std::size_t task, std::size_t shards) const { return ranks_[task] % shards; }
  /// Precision of a task's worker.
  std::string precision(const SweepTask& task) const;

 private:
  struct Axis {
    bool law = false;
    std::size_t law_index = 0;  ///< of the scenario's force laws
    std::string coefficient;    ///< name of a coefficient of that law
    std::string only_entry;     ///< the only entry that reads it; empty: all do
  };
  /// The simulation that a run is a part of, and which of its sets of laws is the run's.
  struct RunSource {
    std::size_t task, law;
  };

  void sortAxes();
  void makeTasks();
  void nameTasks();
  void rankTasks();
  std::string commonText(std::size_t entry) const;
  std::string valueText(std::size_t point, std::size_t entry, bool laws) const;
  bool reads(std::size_t entry, std::size_t axis) const;
  std::string key(std::size_t point, std::size_t entry, bool laws) const;

  SweepManifest manifest_;
  LoadedScenario base_;
  std::vector<Axis> axes_;
  std::vector<std::string> plain_;     ///< of the points' texts: numbers that are equal have equal texts
  std::vector<std::size_t> text_ids_;  ///< of the points' texts: the first with the same plain text
  std::vector<SweepTask> tasks_;
  std::vector<std::size_t> ranks_;      ///< of the tasks among their names
  std::vector<RunSource> run_sources_;  ///< one per run
};

}  // namespace fissure
