#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// The limits of a cluster from `scontrol show config`.
struct SlurmLimits {
  std::size_t max_array_size = 0;  ///< MaxArraySize: bound that indices of an array must stay below
  std::size_t max_job_count = 0;   ///< MaxJobCount of the whole cluster, in which each array task counts

  /// The largest number of tasks in an array with indices from 1, beside one further job.
  std::size_t mostShards() const;
};

/// Whether all programs of Slurm that are needed are on PATH.
bool hasSlurm();
/// Throws InputError where hasSlurm() is false.
void requireSlurm();

/// Asks the cluster for its limits. Throws RunError when it does not answer, InputError when it accepts no
/// arrays.
SlurmLimits slurmLimits();

/// The number of jobs that this user may have submitted at the same time, where each task of an array counts:
/// the smallest MaxSubmitJobs of the user's associations and of their default QOS, from sacctmgr. No value
/// where none is set, or without an answer within `most_s` seconds, because many clusters keep no accounts.
std::optional<std::size_t> submitLimit(double most_s = 4);

/// Runs `sbatch ARGUMENTS...`, without the array and the waiting that the environment may ask for, and
/// returns the id of the job. Throws RunError with the message of sbatch and advice, also when it prints no
/// id within `most_s` seconds.
std::string submitJob(const std::vector<std::string>& arguments, double most_s = 60);

/// A job that this program has submitted, recorded as a line of `<sweep's folder>/slurm/jobs`.
struct SlurmJob {
  std::string id;
  /// "array" or "merge".
  std::string what;
};

/// Appends a job to that file. Throws RunError when that fails.
void recordJob(const std::filesystem::path& folder, const SlurmJob& job);
/// The recorded jobs in the order in which they were submitted; empty when there is no such file.
std::vector<SlurmJob> recordedJobs(const std::filesystem::path& folder);

/// A job that has not ended.
struct QueuedJob {
  SlurmJob job;
  /// Numbers of its tasks by state: "2 running, 5 pending".
  std::string states;
};

/// Those of `jobs` that are queued or running, from squeue. Throws RunError when the cluster does not answer.
std::vector<QueuedJob> queuedJobs(const std::vector<SlurmJob>& jobs);
/// The jobs in words: "12 (array): 2 running, 5 pending; 13 (merge): 1 pending".
std::string describe(const std::vector<QueuedJob>& queued);

}  // namespace fissure
