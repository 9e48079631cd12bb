#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// What a cluster takes, as `scontrol show config` says.
struct SlurmLimits {
  std::size_t max_array_size = 0;  ///< MaxArraySize: indices of an array stay below it
  std::size_t max_job_count = 0;   ///< MaxJobCount: of the whole cluster, each array task counts

  /// Tasks of an array that counts from 1, beside one more job.
  std::size_t mostShards() const;
};

/// Whether all of Slurm's programs that are used here are on PATH.
bool hasSlurm();
/// Throws InputError where hasSlurm() is false.
void requireSlurm();

/// Throws RunError when the cluster does not answer, InputError when it takes no arrays.
SlurmLimits slurmLimits();

/// How many jobs this user may have submitted at a time: the least MaxSubmitJobs of the user's associations
/// and of their default QOS, as sacctmgr says; each task of an array counts. Nothing where none is set, or
/// nobody answers within `most_s` seconds: many clusters keep no accounts.
std::optional<std::size_t> submitLimit(double most_s = 4);

/// `sbatch ARGUMENTS...`, without the array and the waiting that the environment may ask for; the id of the
/// job. Throws RunError with what sbatch says, and what to do about it; also when it says no id within
/// `most_s` seconds.
std::string submitJob(const std::vector<std::string>& arguments, double most_s = 60);

/// A job that this program submitted, as `<sweep's folder>/slurm/jobs` records it, a line each.
struct SlurmJob {
  std::string id;
  std::string what;  ///< "array" or "merge"
};

/// Appends a line. Throws RunError when that fails.
void recordJob(const std::filesystem::path& folder, const SlurmJob& job);
/// In the order in which they were submitted; none when there is no such file.
std::vector<SlurmJob> recordedJobs(const std::filesystem::path& folder);

/// A job that has not ended.
struct QueuedJob {
  SlurmJob job;
  std::string states;  ///< "2 running, 5 pending"
};

/// Which of `jobs` are queued or running, as squeue says. Throws RunError when the cluster does not answer.
std::vector<QueuedJob> queuedJobs(const std::vector<SlurmJob>& jobs);
/// In words: "12 (array): 2 running, 5 pending; 13 (merge): 1 pending".
std::string describe(const std::vector<QueuedJob>& queued);

}  // namespace fissure
