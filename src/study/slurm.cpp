#include "study/slurm.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "process/fed_process.h"
#include "process/tool.h"
#include "study/slurm_scripts.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr double most_s = 60;  // a busy controller takes its time

std::string said(const char* tool, const std::vector<std::string>& arguments) {
  const auto program = programOnPath(tool);
  if (!program) throw RunError(std::string(tool) + ": not on PATH any more");
  const ToolOutcome outcome = runTool(*program, arguments, most_s);
  if (outcome.code == 0) return outcome.output;
  const std::string name = std::string(tool) + ": ";
  if (outcome.error.empty()) throw RunError(name + "exit code " + std::to_string(outcome.code));
  throw RunError(outcome.error.starts_with(name) ? outcome.error : name + outcome.error);
}

std::size_t configured(const std::string& config, const std::string& key) {
  const std::regex line("(^|\n)" + key + "\\s*=\\s*([0-9]{1,9})\\s*(?=\n|$)");
  std::smatch groups;
  if (!std::regex_search(config, groups, line)) throw RunError("scontrol: says no " + key);
  return std::stoul(groups[2]);
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
  for (const char* tool : {"sbatch", "squeue", "scontrol"})
    if (!programOnPath(tool))
      throw InputError("--engine slurm: there is no " + std::string(tool) +
                       " on PATH, expected a machine of a Slurm cluster; elsewhere use --shard I/N");
}

SlurmLimits slurmLimits() {
  const std::string config = said("scontrol", {"show", "config"});
  return {configured(config, "MaxArraySize"), configured(config, "MaxJobCount")};
}

std::string submitJob(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"--parsable"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::string answer = said("sbatch", words);  // the id, on some clusters ";" and the cluster's name
  std::string id = answer.substr(0, answer.find_first_not_of("0123456789"));
  if (id.empty()) throw RunError("sbatch: names no job");
  return id;
}

void recordJob(const fs::path& folder, const SlurmJob& job) {
  const fs::path file = jobsFile(folder);
  const Descriptor jobs(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  const std::string line = job.id + " " + job.what + (job.tasks.empty() ? "" : " ") + job.tasks + "\n";
  if (!jobs.open() || ::write(jobs.number(), line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    throw RunError(file.string() + ": cannot write: " + std::strerror(errno) + "; job " + job.id +
                   " is queued all the same");
}

std::vector<SlurmJob> recordedJobs(const fs::path& folder) {
  std::vector<SlurmJob> jobs;
  std::ifstream stream(jobsFile(folder));
  for (std::string line; std::getline(stream, line);) {
    SlurmJob job;
    std::istringstream(line) >> job.id >> job.what >> job.tasks;
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
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + name;
    queued.push_back({job, text});
  }
  return queued;
}

std::string describe(const std::vector<QueuedJob>& queued) {
  std::string text;
  for (const QueuedJob& each : queued)
    text += (text.empty() ? "" : "; ") + each.job.id + " (" + each.job.what + "): " + each.states;
  return text;
}

}  // namespace fissure
