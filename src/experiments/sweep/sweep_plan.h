#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenario/load.h"
#include "scenario/yaml_document.h"
#include "sweep/sweep_manifest.h"

namespace fissure {

/// One simulation of a sweep, in one worker process.
struct SweepTask {
  /// Hash of everything on which its numbers depend (scenario, overrides, laws, entry, repeat, input files,
  /// worker program), 16 hexadecimal digits. Equal tasks have equal ids in every sweep, shard and session.
  std::string id;
  std::size_t entry = 0;  ///< index in the manifest's pipelines
  int repeat = 0;
  std::size_t point = 0;  ///< a point whose values, except those of force laws, it simulates
  /// One point per set of force laws; a single one: the laws are those of the simulated scenario.
  std::vector<std::size_t> laws;
};

/// One row of the table: a point run with a pipeline entry.
struct PlannedRun {
  std::size_t point = 0;
  std::size_t entry = 0;
  int repeat = 0;
  std::size_t task = 0;
  std::size_t law = 0;  ///< index in SweepTask::laws
};

/// The runs and simulations that follow from a manifest. Points that differ only in coefficients of force
/// laws share a simulation, as do points that differ only in settings of other entries. Runs are in the order
/// point (slowest), entry, repeat; tasks are in the order of their first runs.
class SweepPlan {
 public:
  /// `folder`: the sweep's folder. Throws InputError when the manifest's scenario cannot be read or a
  /// coefficient is no number.
  SweepPlan(SweepManifest manifest, const std::filesystem::path& folder);

  const SweepManifest& manifest() const { return manifest_; }
  /// The base scenario; its input files need not exist.
  const LoadedScenario& base() const { return base_; }
  /// The folder of relative file names of the scenario.
  const std::filesystem::path& directory() const { return base_.scenario.directory; }

  /// Whether a result file is kept of each simulation.
  bool keepsResults() const { return manifest_.settings.keep != SweepKeep::metrics; }
  std::size_t runs() const { return run_sources_.size(); }
  PlannedRun run(std::size_t index) const;
  const std::vector<SweepTask>& tasks() const { return tasks_; }

  /// Whether an axis only changes a coefficient of a force law that moves no tool.
  bool isLawAxis(std::size_t axis) const { return axes_[axis].law; }
  /// The differences between the scenario of a task and the base: the values of all axes that its entry
  /// reads, without law axes where the task has several sets of laws.
  std::vector<Override> overrides(const SweepTask& task) const;
  /// The values of all axes at a point.
  std::vector<Override> overridesAt(std::size_t point) const;
  /// The force laws of a point, in the scenario's order.
  std::vector<ForceSettings> lawsAt(std::size_t point) const;
  const PipelineSettings& entry(std::size_t index) const;
  /// The shard, from 0 to `shards` - 1, to which a task belongs; the same in every session of this plan.
  std::size_t shardOf(std::size_t task, std::size_t shards) const { return ranks_[task] % shards; }
  /// Precision of a task's worker.
  std::string precision(const SweepTask& task) const;
  /// Whether an axis changes anything of an entry: not, where it is a setting of another one.
  bool reads(std::size_t entry, std::size_t axis) const;

 private:
  struct Axis {
    bool law = false;
    std::size_t law_index = 0;  ///< index in the scenario's force laws
    std::string coefficient;    ///< name of a coefficient of that law
    std::string only_entry;     ///< the only entry that reads it; empty: all do
  };
  /// The simulation of a run, and the index of the run's set of laws in it.
  struct RunSource {
    std::size_t task, law;
  };

  void sortAxes();
  void makeTasks();
  void nameTasks();
  void rankTasks();
  std::string commonText(std::size_t entry) const;
  std::string valueText(std::size_t point, std::size_t entry, bool laws) const;
  std::string key(std::size_t point, std::size_t entry, bool laws) const;

  SweepManifest manifest_;
  LoadedScenario base_;
  std::vector<Axis> axes_;
  std::vector<std::string> plain_;     ///< plainValue() of the points' texts
  std::vector<std::size_t> text_ids_;  ///< [text] index of the first text with the same plain text
  std::vector<SweepTask> tasks_;
  std::vector<std::size_t> ranks_;      ///< [task] rank of its id among all ids
  std::vector<RunSource> run_sources_;  ///< one per run
};

/// What the tasks of an entry simulate, before axes: the base scenario without descriptions, expectations and
/// other entries.
YamlNode physicsOf(const SweepManifest& manifest, std::size_t entry);

}  // namespace fissure
