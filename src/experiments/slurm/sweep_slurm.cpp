#include "slurm/sweep_slurm.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <ostream>
#include <set>

#include "base/counted.h"
#include "base/error.h"
#include "files/write_file.h"
#include "process/progress_display.h"
#include "slurm/sbatch_options.h"
#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr double default_shard_minutes = 20;  // a slot of a cluster idles for a second or three a task

std::string thisProgram() {
  return shellWord(fs::read_symlink("/proc/self/exe").string());
}

bool isUnedited(const std::string& text, const ArrayScript& script) {
  return text == arrayScriptText(script);
}

/// Shards with a task among `tasks`.
std::string rangesOf(const SweepPlan& plan, const std::vector<std::size_t>& tasks, std::size_t shards) {
  std::set<std::size_t> missing;
  for (const std::size_t task : tasks) missing.insert(plan.shardOf(task, shards) + 1);
  return arrayRanges({missing.begin(), missing.end()});
}

/// For people.
std::string shortened(const std::string& ranges) {
  constexpr std::size_t most = 60;
  return ranges.size() <= most ? ranges : ranges.substr(0, ranges.rfind(',', most)) + ",...";
}

std::string words(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) text.append(" ").append(shellWord(argument));
  return text;
}

}  // namespace

SlurmSubmission::SlurmSubmission(fs::path folder, SlurmOptions options, std::optional<int> slots)
    : folder_(std::move(folder)), options_(std::move(options)), given_slots_(slots) {
  if (!options_.sbatch.empty() && !options_.sbatch.front().starts_with('-'))
    throw InputError(
        fmt::format("sweep: {} was not expected; options of sbatch come after --", options_.sbatch.front()));
  refuseUnfitOptions(options_.sbatch);
  if (fs::absolute(folder_).string().find_first_of("%\\") != std::string::npos)
    throw InputError(
        fs::absolute(folder_).string() +
        ": Slurm takes % and \\ in the names of its logs as patterns, expected a folder without");
  requireSlurm();
  limits_ = slurmLimits();
  if (!options_.no_submit && !options_.dry_run) queued_ = queuedJobs(recordedJobs(folder_));
  if (!queued_.empty() && !options_.again)
    throw InputError(
        inFile(folder_),
        fmt::format("jobs of this sweep are queued, {}; expected their end, or --again", describe(queued_)));
  std::error_code ignored;
  if (fs::exists(arrayScriptFile(folder_), ignored)) {
    array_text_ = readTextFile(arrayScriptFile(folder_));
    array_ = readArrayScript(array_text_, arrayScriptFile(folder_));
  }
  slots_ = slots ? *slots : array_ ? static_cast<int>(array_->cpus) : 1;
}

bool SlurmSubmission::keepsShards(std::size_t simulations) const {
  return !options_.shard_minutes && array_ && array_->simulations == simulations &&
         array_->shards <= limits_.mostShards();
}

ArrayScript SlurmSubmission::choose(const SweepPlan& plan, std::size_t tasks, const SweepEstimate& estimate,
                                    std::ostream& out) const {
  const std::size_t most = limits_.mostShards();
  const std::string here = fmt::format("this cluster takes {} in an array (MaxArraySize {}, MaxJobCount {})",
                                       most, limits_.max_array_size, limits_.max_job_count);
  const std::size_t all = plan.tasks().size();
  std::size_t shards = 1;
  if (options_.shards) {
    shards = static_cast<std::size_t>(*options_.shards);
    if (shards > most) throw InputError(fmt::format("--shards {}: {}, expected at most that", shards, here));
    shards = std::min(shards, all);
  } else if (keepsShards(all)) {
    shards = array_->shards;
  } else {
    const double by_time = estimate.one_s
                               ? std::ceil(estimate.total_s(tasks, slots_) /
                                           (60 * options_.shard_minutes.value_or(default_shard_minutes)))
                               : static_cast<double>(tasks);
    const std::size_t wished = std::min(tasks, static_cast<std::size_t>(std::max(1.0, by_time)));
    const std::optional<std::size_t> jobs = wished > 1 ? submitLimit() : std::nullopt;
    const std::size_t may = jobs ? std::max<std::size_t>(*jobs, 2) - 1 : most;
    shards = std::max<std::size_t>(1, std::min({wished, most, may}));
    if (shards < wished)
      out << "slurm: " << wished << " shards would be right, "
          << (may < most ? fmt::format("you may have {} beside the merge (MaxSubmitJobs)", may) : here)
          << "\n";
  }
  return {plan.manifest().settings.name,    all,           shards,
          static_cast<std::size_t>(slots_), thisProgram(), array_ ? array_->throttle : ""};
}

void SlurmSubmission::writeScripts(const ArrayScript& script, std::ostream& out) const {
  std::error_code error;
  fs::create_directories(slurmFolder(folder_) / "logs", error);
  if (error) throw RunError(slurmFolder(folder_).string() + ": cannot be made: " + error.message());
  const fs::path array = arrayScriptFile(folder_), merge = mergeScriptFile(folder_);
  if (!array_ || isUnedited(array_text_, *array_)) {
    replaceFile(array, arrayScriptText(script));
  } else {
    const bool other = array_->shards != script.shards;
    out << array.string() << ": was edited, and is kept"
        << (other ? " but for its number of shards, now " + std::to_string(script.shards) : "") << "\n";
    if (array_->program != script.program)
      out << array.string() << ": runs " << array_->program << ", not this program\n";
    replaceFile(array, withShards(array_text_, script));
  }
  if (fs::exists(merge, error) && !isUneditedMergeScript(readTextFile(merge), script.sweep))
    out << merge.string() << ": was edited, and is kept\n";
  else
    replaceFile(merge, mergeScriptText(script.sweep, script.program));
}

std::vector<std::string> SlurmSubmission::arrayArguments(const std::string& ranges) const {
  std::vector<std::string> arguments = options_.sbatch;
  if (given_slots_) arguments.push_back("--cpus-per-task=" + std::to_string(slots_));
  arguments.push_back("--array=" + ranges + (array_ ? array_->throttle : ""));
  return arguments;
}

std::string SlurmSubmission::submitArray(const std::string& ranges, std::size_t shards, std::ostream& out) {
  std::vector<std::string> arguments = arrayArguments(ranges);
  arguments.push_back("--chdir=" + fs::absolute(folder_).string());
  arguments.push_back(fs::absolute(arrayScriptFile(folder_)).string());
  const SlurmJob job = {submitJob(arguments), "array"};
  out << "slurm: job " << job.id << " runs shards " << shortened(ranges) << " of " << shards << "\n";
  queued_.push_back({job, ""});
  recordJob(folder_, job);
  return job.id;
}

/// The user's options are those of both jobs, but two jobs cannot share one log.
std::vector<std::string> SlurmSubmission::mergeArguments(const std::string& after) const {
  std::vector<std::string> arguments = options_.sbatch;
  if (nameOutput(arguments)) arguments.emplace_back("--output=slurm/logs/merge_%j.log");
  if (!after.empty()) arguments.push_back("--dependency=afterany:" + after);
  return arguments;
}

void SlurmSubmission::submitMerge(Submitted& submitted, std::ostream& out) const {
  std::string after;
  for (const QueuedJob& earlier : queued_)
    if (earlier.job.what == "array") after += (after.empty() ? "" : ":") + earlier.job.id;
  std::vector<std::string> arguments = mergeArguments(after);
  arguments.push_back("--chdir=" + fs::absolute(folder_).string());
  arguments.push_back(fs::absolute(mergeScriptFile(folder_)).string());
  try {
    submitted.merge_job = submitJob(arguments);
  } catch (const RunError& error) {
    const std::string when = after.empty()
                                 ? "to merge"
                                 : fmt::format("the shards are queued, job {}; when they have ended", after);
    submitted.merge_refused = fmt::format("the merge was not submitted: {}; {}: fissure sweep merge {}",
                                          error.what(), when, shellWord(folder_.string()));
    return;
  }
  out << "slurm: job " << submitted.merge_job << " merges" << (after.empty() ? "" : " when they have ended")
      << "\n";
  recordJob(folder_, {submitted.merge_job, "merge"});
}

void SlurmSubmission::printCommands(const std::string& ranges, std::ostream& out) const {
  out << "nothing was submitted; to do that:\n  cd " << shellWord(folder_.string()) << "\n";
  if (std::getenv("SBATCH_ARRAY_INX")) out << "  unset SBATCH_ARRAY_INX\n";
  std::string after;
  if (!ranges.empty()) {
    out << "  job=$(sbatch --parsable" << words(arrayArguments(ranges)) << " slurm/array.sbatch)\n";
    after = " --dependency=afterany:${job%%;*}";
  }
  out << "  sbatch" << words(mergeArguments("")) << after << " slurm/merge.sbatch\n";
}

Submitted SlurmSubmission::submit(const SweepPlan& plan, const std::vector<std::size_t>& tasks,
                                  const SweepEstimate& estimate, std::ostream& out) {
  const ArrayScript script = choose(plan, tasks.size(), estimate, out);
  const std::string ranges = rangesOf(plan, tasks, script.shards);
  out << "slurm: " << counted(static_cast<std::size_t>(script.shards), "shard") << " with "
      << counted(static_cast<std::size_t>(script.cpus), "CPU");
  if (estimate.one_s && !tasks.empty()) {
    const std::size_t each = (tasks.size() + script.shards - 1) / script.shards;
    out << ", about " << durationText(estimate.total_s(each, slots_)) << " each";
  }
  out << (ranges.empty() ? "; nothing is missing" : "; to run: " + shortened(ranges)) << "\n";
  Submitted submitted = {script.shards, ranges, "", "", ""};
  if (options_.dry_run) return submitted;
  writeScripts(script, out);
  if (options_.no_submit) {
    printCommands(ranges, out);
    return submitted;
  }
  if (!ranges.empty()) submitted.array_job = submitArray(ranges, script.shards, out);
  submitMerge(submitted, out);
  return submitted;
}

void printJobs(const fs::path& folder, std::ostream& out) {
  const std::vector<SlurmJob> jobs = recordedJobs(folder);
  if (jobs.empty() || !hasSlurm()) return;
  try {
    const std::vector<QueuedJob> queued = queuedJobs(jobs);
    out << "slurm: " << (queued.empty() ? "no job of this sweep is queued" : describe(queued)) << "\n";
  } catch (const RunError& error) {
    out << "slurm: " << error.what() << "\n";
  }
}

}  // namespace fissure
