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

/// The command-line options of sweeps on a Slurm cluster.
struct SlurmOptions {
  /// "local" or "slurm".
  std::string engine = "local";
  std::optional<int> shards;  ///< number of shards; default: from shard_minutes, later as in the script
  std::optional<double> shard_minutes;  ///< intended wall time of a shard; default: 20
  bool no_submit = false;
  bool dry_run = false;
  bool again = false;  ///< submit although jobs of this sweep are queued
  /// Options for sbatch: the words after "--".
  std::vector<std::string> sbatch;
};

/// The submitted jobs.
struct Submitted {
  std::size_t shards = 1;
  /// Shards with missing simulations, in the syntax of sbatch: "1,4-7".
  std::string missing;
  std::string array_job, merge_job;  ///< job ids; empty: not submitted
  std::string merge_refused;         ///< why the merge job could not be submitted; empty: no problem
};

/// Submits a sweep to a Slurm cluster: writes its sbatch files and submits jobs for the missing simulations.
/// These are known from the sweep's own files; Slurm is asked only for jobs that still wait or run, to avoid
/// submitting twice.
class SlurmSubmission {
 public:
  /// `slots`: simulations at the same time per shard; default: as in the sweep's array.sbatch, else 1. Throws
  /// InputError where there is no Slurm, for unfit options of sbatch, or while jobs of this sweep are queued;
  /// RunError where the cluster does not answer.
  SlurmSubmission(std::filesystem::path folder, SlurmOptions options, std::optional<int> slots);

  int slots() const { return slots_; }
  /// Whether the number of shards depends on the wall time of simulations, for a plan with this number of
  /// them.
  bool choosesByTime(std::size_t simulations) const { return !options_.shards && !keepsShards(simulations); }

  /// Submits jobs for `tasks`, the unfinished tasks of the plan, whose manifest must be in the folder.
  /// Reports to `out`. Throws InputError for more shards than the cluster accepts, RunError when sbatch
  /// refuses the array.
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
  std::string array_text_;            ///< text of the existing array.sbatch
  std::optional<ArrayScript> array_;  ///< values in that file
};

/// Prints a line about the recorded jobs of a sweep; nothing where there are none, or without Slurm.
void printJobs(const std::filesystem::path& folder, std::ostream& out);

}  // namespace fissure
