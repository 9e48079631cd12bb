#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "slurm/slurm.h"
#include "slurm/slurm_scripts.h"
#include "sweep/sweep_estimate.h"

namespace fissure {

struct SlurmOptions {
  std::string engine = "local";         ///< or "slurm"
  std::optional<int> shards;            ///< default: by shard_minutes, later as they were
  std::optional<double> shard_minutes;  ///< wall time that a shard should take; default: 20
  bool no_submit = false;
  bool dry_run = false;
  bool again = false;               ///< although jobs of this sweep are queued
  std::vector<std::string> sbatch;  ///< its options, what follows "--"
};

/// What was submitted.
struct Submitted {
  std::size_t shards = 1;
  std::string missing;               ///< shards that miss something, as sbatch wants them: "1,4-7"
  std::string array_job, merge_job;  ///< empty: not submitted
  std::string merge_refused;         ///< why the merge was not, though it should
};

/// A sweep on a Slurm cluster: writes its sbatch files and submits what is missing. What is missing is read
/// from the sweep's own files alone; Slurm is only asked which jobs still wait, so as not to submit twice.
class SlurmSubmission {
 public:
  /// `slots`: of each shard; default: as in the sweep's array.sbatch, else 1. Throws InputError where there
  /// is no Slurm, the options of sbatch do not fit, or while jobs of this sweep are queued; RunError where
  /// the cluster does not answer.
  SlurmSubmission(std::filesystem::path folder, SlurmOptions options, std::optional<int> slots);

  int slots() const { return slots_; }
  /// Whether the number of shards depends on how long simulations take, in a plan of so many.
  bool choosesByTime(std::size_t simulations) const { return !options_.shards && !keepsShards(simulations); }

  /// `tasks`: unfinished ones of the plan, whose manifest is in the folder. Says on `out` what it does.
  /// Throws InputError for more shards than the cluster takes, RunError when sbatch refuses the array.
  Submitted submit(const SweepPlan& plan, const std::vector<std::size_t>& tasks,
                   const SweepEstimate& estimate, std::ostream& out);

 private:
  bool keepsShards(std::size_t simulations) const;
  ArrayScript choose(const SweepPlan& plan, std::size_t tasks, const SweepEstimate& estimate,
                     std::ostream& out) const;
  void writeScripts(const ArrayScript& script, std::ostream& out) const;
  std::vector<std::string> arrayArguments(const std::string& ranges) const;
  std::vector<std::string> mergeArguments(const std::string& after) const;
  std::string submitArray(const std::string& ranges, std::size_t shards, std::ostream& out);
  void submitMerge(Submitted& submitted, std::ostream& out) const;
  void printCommands(const std::string& ranges, std::ostream& out) const;

  std::filesystem::path folder_;
  SlurmOptions options_;
  std::optional<int> given_slots_;
  int slots_ = 1;
  SlurmLimits limits_;
  std::vector<QueuedJob> queued_;
  std::string array_text_;            ///< of the file that is there
  std::optional<ArrayScript> array_;  ///< what it says
};

/// A line about the jobs of a sweep that were recorded; nothing where none were, or there is no Slurm here.
void printJobs(const std::filesystem::path& folder, std::ostream& out);

}  // namespace fissure
