#include "slurm/slurm.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <map>
#include <sstream>
#include <string_view>

#include "base/error.h"
#include "process/fed_process.h"
#include "process/system_program.h"
#include "slurm/slurm_scripts.h"
#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr double patience_s = 60;  // a busy controller takes its time

std::string onPath(const char* name) {
  const auto program = programOnPath(name);
  if (!program) throw RunError(std::string(name) + ": not on PATH");
  return program->string();
}

std::string noAnswer(const char* name, double most_s) {
  std::ostringstream reason;
  reason << name << ": no answer within " << most_s << " s";
  return reason.str();
}

/// Why a program failed that ended.
std::string failureOf(const char* name, const ProgramOutcome& outcome) {
  const std::string start = std::string(name) + ": ";
  if (outcome.error.empty()) return start + "exit code " + std::to_string(outcome.code);
  return outcome.error.starts_with(start) ? outcome.error : start + outcome.error;
}

/// What a program says. Throws RunError unless all went well.
std::string said(const char* name, const std::vector<std::string>& arguments, double most_s = patience_s) {
  const ProgramOutcome outcome = runProgram(onPath(name), arguments, most_s);
  if (!outcome.in_time) throw RunError(noAnswer(name, most_s));
  if (outcome.code != 0) throw RunError(failureOf(name, outcome));
  return outcome.output;
}

/// Fields of the lines of `sacctmgr --parsable2`.
std::vector<std::vector<std::string>> accounts(std::vector<std::string> arguments, double most_s) {
  arguments.insert(arguments.begin(), {"--noheader", "--parsable2", "show"});
  std::istringstream lines(said("sacctmgr", arguments, most_s));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream fields(line + "|");
    for (std::string field; std::getline(fields, field, '|');) row.push_back(field);
  }
  return rows;
}

std::string userName() {
  const passwd* user = ::getpwuid(::getuid());
  return user ? user->pw_name : std::to_string(::getuid());
}

void takeLeast(std::optional<std::size_t>& least, const std::string& number) {
  const std::optional<int> limit = toInt(number);
  if (limit && *limit >= 0) least = std::min(least.value_or(*limit), static_cast<std::size_t>(*limit));
}

/// Takes what comes next in `text` of these letters.
std::string_view take(std::string_view& text, const char* letters) {
  const std::string_view taken = text.substr(0, text.find_first_not_of(letters));
  text.remove_prefix(taken.size());
  return taken;
}

/// The number, of one to nine digits, that a line `key = number` of scontrol's says.
std::size_t configured(const std::string& config, const std::string& key) {
  constexpr const char* spaces = " \t\n\v\f\r";
  for (std::size_t at = 0; (at = config.find(key, at)) != std::string::npos; ++at) {
    if (at > 0 && config[at - 1] != '\n') continue;
    std::string_view rest = std::string_view(config).substr(at + key.size());
    take(rest, spaces);
    if (!rest.starts_with('=')) continue;
    rest.remove_prefix(1);
    take(rest, spaces);
    const std::string digits(take(rest, "0123456789"));
    const bool whole = take(rest, spaces).find('\n') != std::string_view::npos || rest.empty();
    if (!digits.empty() && digits.size() <= 9 && whole) return std::stoul(digits);
  }
  throw RunError("scontrol: says no " + key);
}

fs::path jobsFile(const fs::path& folder) {
  return slurmFolder(folder) / "jobs";
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

}  // namespace

std::size_t SlurmLimits::mostShards() const {
  return std::max<std::size_t>(std::min(max_array_size, max_job_count), 2) - 1;
}

bool hasSlurm() {
  return programOnPath("sbatch") && programOnPath("squeue") && programOnPath("scontrol");
}

void requireSlurm() {
  for (const char* name : {"sbatch", "squeue", "scontrol"})
    if (!programOnPath(name))
      throw InputError(
          fmt::format("--engine slurm: there is no {} on PATH, expected a machine of a Slurm cluster; "
                      "elsewhere use --shard I/N",
                      name));
}

SlurmLimits slurmLimits() {
  const std::string config = said("scontrol", {"show", "config"});
  const SlurmLimits limits = {configured(config, "MaxArraySize"), configured(config, "MaxJobCount")};
  if (limits.max_array_size < 2)
    throw InputError(
        fmt::format("--engine slurm: this cluster takes no arrays (MaxArraySize {}), expected jobs of your "
                    "own with --shard I/N",
                    limits.max_array_size));
  return limits;
}

std::optional<std::size_t> submitLimit(double most_s) {
  std::optional<std::size_t> least;
  try {
    std::string qos;
    for (const std::vector<std::string>& row :
         accounts({"assoc", "where", "user=" + userName(), "format=MaxSubmitJobs,DefaultQOS"}, most_s)) {
      takeLeast(least, row[0]);
      if (row.size() > 1 && !row[1].empty()) qos += (qos.empty() ? "" : ",") + row[1];
    }
    if (qos.empty()) return least;
    for (const std::vector<std::string>& row :
         accounts({"qos", "where", "name=" + qos, "format=MaxSubmitJobsPerUser"}, most_s))
      takeLeast(least, row[0]);
  } catch (const RunError&) {  // no accounts are kept, or their daemon is down
  }
  return least;
}

std::string submitJob(const std::vector<std::string>& arguments, double most_s) {
  std::vector<std::string> words = {"-u", "SBATCH_ARRAY_INX", onPath("sbatch"), "--parsable"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const ProgramOutcome outcome = runProgram("/usr/bin/env", words, most_s);
  // The id, on some clusters ";" and the cluster's name; a line that is not whole may be half a number.
  const std::string line = outcome.output.substr(0, outcome.output.find('\n') + 1);
  std::string id = line.substr(0, line.find_first_not_of("0123456789"));
  if (!outcome.in_time && id.empty())
    throw RunError(noAnswer("sbatch", most_s) + "; the job may be queued all the same, squeue says that");
  if (outcome.in_time && outcome.code != 0) {
    const bool too_many = outcome.error.find("submit limit") != std::string::npos;
    throw RunError(failureOf("sbatch", outcome) +
                   (too_many ? "; if these are too many jobs at a time: fewer tasks with --shards N" : ""));
  }
  if (id.empty()) throw RunError("sbatch: names no job");
  return id;
}

void recordJob(const fs::path& folder, const SlurmJob& job) {
  const fs::path file = jobsFile(folder);
  const Descriptor jobs(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  const std::string line = job.id + " " + job.what + "\n";
  if (!jobs.open() || ::write(jobs.number(), line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    throw RunError(fmt::format("{}: cannot write: {}; job {} is queued all the same", file.string(),
                               std::strerror(errno), job.id));
}

std::vector<SlurmJob> recordedJobs(const fs::path& folder) {
  std::vector<SlurmJob> jobs;
  std::error_code ignored;
  if (!fs::exists(jobsFile(folder), ignored)) return jobs;
  std::istringstream lines(readTextFile(jobsFile(folder)));
  for (std::string line; std::getline(lines, line);) {
    SlurmJob job;
    std::istringstream(line) >> job.id >> job.what;
    if (!job.id.empty() && job.id.find_first_not_of("0123456789") == std::string::npos)
      jobs.push_back(std::move(job));
  }
  return jobs;
}

std::vector<QueuedJob> queuedJobs(const std::vector<SlurmJob>& jobs) {
  if (jobs.empty()) return {};
  std::istringstream lines(
      said("squeue", {"--noheader", "--array", "--user=" + std::to_string(::getuid()), "--format=%F %T"}));
  std::map<std::string, std::map<std::string, int>> states;
  std::string id, state;
  while (lines >> id >> state) ++states[id][lowered(state)];
  std::vector<QueuedJob> queued;
  for (const SlurmJob& job : jobs) {
    const auto found = states.find(job.id);
    if (found == states.end()) continue;
    std::string text;
    for (const auto& [name, count] : found->second)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
    queued.push_back({job, text});
  }
  return queued;
}

std::string describe(const std::vector<QueuedJob>& queued) {
  std::string text;
  for (const QueuedJob& each : queued)
    text += fmt::format("{}{} ({}): {}", text.empty() ? "" : "; ", each.job.id, each.job.what, each.states);
  return text;
}

}  // namespace fissure
