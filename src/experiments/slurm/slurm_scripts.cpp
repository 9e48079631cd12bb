#include "slurm/slurm_scripts.h"

#include <algorithm>
#include <regex>

#include "base/error.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

// Patterns of whole lines, so that what people write around them does not matter.
constexpr const char* about_pattern = "# Sweep (\\S+): ([0-9]+) simulations dealt to ([0-9]+) shards\\..*";
constexpr const char* array_pattern = "#SBATCH --array=1-([0-9]+)(%[0-9]+)?[ \\t]*";
constexpr const char* cpus_pattern = "#SBATCH --cpus-per-task=([0-9]+)[ \\t]*";
constexpr const char* shards_pattern = "shards=([0-9]+)[ \\t]*";
constexpr const char* program_pattern = "program=(.*)";

std::string aboutLine(const ArrayScript& script) {
  return "# Sweep " + script.sweep + ": " + std::to_string(script.simulations) + " simulations dealt to " +
         std::to_string(script.shards) + " shards.";
}

std::string arrayLine(const ArrayScript& script) {
  return "#SBATCH --array=1-" + std::to_string(script.shards) + script.throttle;
}

std::string shardsLine(const ArrayScript& script) {
  return "shards=" + std::to_string(script.shards);
}

/// First and last byte of the first line that fits, and what its groups are.
struct Line {
  std::size_t at = 0, length = 0;
  std::smatch groups;
};

bool findLine(const std::string& text, const char* pattern, Line& line) {
  const std::regex expression(pattern);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const auto first = text.begin() + static_cast<std::ptrdiff_t>(at);
    if (std::regex_match(first, text.begin() + static_cast<std::ptrdiff_t>(end), line.groups, expression)) {
      line.at = at;
      line.length = end - at;
      return true;
    }
    at = end + 1;
  }
  return false;
}

std::size_t numberOf(const std::smatch& groups, std::size_t group) {
  const std::string digits = groups[group];
  return digits.size() > 9 ? 999999999 : std::stoul(digits);
}

void replaceLine(std::string& text, const char* pattern, const std::string& by) {
  Line line;
  if (findLine(text, pattern, line)) text.replace(line.at, line.length, by);
}

}  // namespace

fs::path slurmFolder(const fs::path& folder) {
  return folder / "slurm";
}

fs::path arrayScriptFile(const fs::path& folder) {
  return slurmFolder(folder) / "array.sbatch";
}

fs::path mergeScriptFile(const fs::path& folder) {
  return slurmFolder(folder) / "merge.sbatch";
}

std::string shellWord(const std::string& text) {
  constexpr const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=:,./%@";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string word = "'";
  for (const char letter : text) word += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return word + "'";
}

std::string arrayScriptText(const ArrayScript& script) {
  return "#!/bin/bash\n" + aboutLine(script) + R"(
# Each array task runs what its shard still misses; the journals of the sweep say what that is, never Slurm. A
# task may be killed, requeued or run twice at the same time: nothing is lost, and the table is the same.
#
# `fissure sweep FOLDER --engine slurm` submits the shards that miss something. It keeps this file as you
# edit it, but for the number of shards, and writes it anew where it is missing. By hand, from the sweep's
# folder: sbatch slurm/array.sbatch
#
#SBATCH --job-name=fissure-)" +
         script.sweep + "\n" + arrayLine(script) +
         "\n#SBATCH --cpus-per-task=" + std::to_string(script.cpus) + R"(
#SBATCH --output=slurm/logs/%A_%a.log
#SBATCH --open-mode=append
#SBATCH --requeue
#SBATCH --signal=B:USR1@120
#
# What your cluster wants: take one # away where you need a line. For eight shards at a time: --array=1-N%8.
##SBATCH --partition=NAME
##SBATCH --account=NAME
##SBATCH --time=02:00:00
##SBATCH --mem-per-cpu=1G

# What the program needs (module load ...) goes here.

)" + shardsLine(script) +
         "\nprogram=" + script.program + R"(

said=$(mktemp) || said=$(mktemp slurm/logs/said.XXXXXX) || said=/dev/null
"$program" sweep . --shard "$SLURM_ARRAY_TASK_ID/$shards" -j "${SLURM_CPUS_PER_TASK:-1}" --json > "$said" &
session=$!

# Two minutes before the time limit Slurm sends USR1: the session ends, with all it has finished recorded.
time_is_up=
trap 'time_is_up=yes; kill -TERM "$session"' USR1
trap 'kill -TERM "$session"' TERM
while kill -0 "$session" 2> /dev/null; do wait "$session"; done
wait "$session"
code=$?
progress=$(grep '"advanced": [1-9]' "$said")
[[ $said == /dev/null ]] || rm -f "$said"

# Then this task queues again for the rest, unless it finished no simulation and tried none for the first
# time: it would not the next time either.
if [[ $time_is_up && $code == 130 && $progress ]]; then
  echo "time is up: back to the queue"
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$code"
)";
}

std::string mergeScriptText(const std::string& sweep, const std::string& program) {
  return R"(#!/bin/bash
# Sweep )" +
         sweep +
         R"(: writes sweep.h5 and sweep.csv of all that is finished. Exit code 3: runs are missing or failed.
# It starts when the array has ended, however it did. By hand, from the sweep's folder:
#   sbatch slurm/merge.sbatch
#
#SBATCH --job-name=fissure-)" +
         sweep + R"(-merge
#SBATCH --output=slurm/logs/merge_%j.log
#SBATCH --open-mode=append
#
##SBATCH --partition=NAME
##SBATCH --account=NAME
##SBATCH --time=00:30:00
##SBATCH --mem=2G

program=)" +
         program + R"(
exec "$program" sweep merge .
)";
}

ArrayScript readArrayScript(const std::string& text, const fs::path& file) {
  const auto need = [&](const char* pattern, const char* expected) {
    Line line;
    if (!findLine(text, pattern, line))
      throw InputError(file.string() + ": has no line " + expected +
                       ", expected it as it was written, or no file, to have it written anew");
    return line.groups;
  };
  ArrayScript script;
  const std::smatch about = need(about_pattern, "\"# Sweep NAME: M simulations dealt to N shards.\"");
  script.sweep = about[1];
  script.simulations = numberOf(about, 2);
  const std::smatch array = need(array_pattern, "#SBATCH --array=1-N");
  script.throttle = array[2];
  script.cpus = numberOf(need(cpus_pattern, "#SBATCH --cpus-per-task=N"), 1);
  script.shards = numberOf(need(shards_pattern, "shards=N"), 1);
  script.program = need(program_pattern, "program='...'")[1];
  if (script.shards == 0) throw InputError(file.string() + ": shards=0, expected at least 1");
  if (numberOf(array, 1) != script.shards)
    throw InputError(file.string() + ": --array=1-" + array[1].str() + " with " + shardsLine(script) +
                     ", expected the same number in both; to change it, --shards N");
  return script;
}

std::string withShards(std::string text, const ArrayScript& script) {
  replaceLine(text, about_pattern, aboutLine(script));
  replaceLine(text, array_pattern, arrayLine(script));
  replaceLine(text, shards_pattern, shardsLine(script));
  return text;
}

bool isUneditedMergeScript(const std::string& text, const std::string& sweep) {
  Line line;
  return findLine(text, program_pattern, line) && text == mergeScriptText(sweep, line.groups[1]);
}

std::string arrayRanges(const std::vector<std::size_t>& indices) {
  std::string ranges;
  for (std::size_t i = 0; i < indices.size();) {
    std::size_t last = i;
    while (last + 1 < indices.size() && indices[last + 1] == indices[last] + 1) ++last;
    ranges.append(ranges.empty() ? "" : ",").append(std::to_string(indices[i]));
    if (last > i) ranges.append("-").append(std::to_string(indices[last]));
    i = last + 1;
  }
  constexpr std::size_t longest = 16000;  // far below what one word of a command may have
  if (ranges.size() > longest) return std::to_string(indices.front()) + "-" + std::to_string(indices.back());
  return ranges;
}

}  // namespace fissure
