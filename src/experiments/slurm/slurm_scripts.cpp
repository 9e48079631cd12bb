#include "slurm/slurm_scripts.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

std::string aboutLine(const ArrayScript& script) {
  return fmt::format("# Sweep {}: {} simulations dealt to {} shards.", script.sweep, script.simulations,
                     script.shards);
}

std::string arrayLine(const ArrayScript& script) {
  return fmt::format("#SBATCH --array=1-{}{}", script.shards, script.throttle);
}

std::string shardsLine(const ArrayScript& script) {
  return "shards=" + std::to_string(script.shards);
}

/// Takes a line apart, from its left to its right.
class LineScanner {
 public:
  explicit LineScanner(std::string_view line) : rest_(line) {}

  /// Whether `text` comes next; it is passed then.
  bool pass(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  /// What comes next up to one of these letters; may be empty.
  std::string takeUntil(const char* letters) { return taken(rest_.find_first_of(letters)); }
  /// The digits that come next; may be none.
  std::string digits() { return taken(rest_.find_first_not_of("0123456789")); }
  /// Whether no more comes than blanks.
  bool ends() const { return rest_.find_first_not_of(" \t") == std::string_view::npos; }
  /// Whether the line is one that anything may end: a carriage return makes it another one.
  bool endsAnyhow() const { return rest_.find('\r') == std::string_view::npos; }
  std::string rest() const { return std::string(rest_); }

 private:
  std::string taken(std::size_t length) {
    std::string text(rest_.substr(0, length));
    rest_.remove_prefix(text.size());
    return text;
  }

  std::string_view rest_;
};

// The lines that are looked for. Each is a whole line, so that what people write around it does not matter;
// numbers are digits as they are written.

/// "# Sweep NAME: M simulations dealt to N shards.", and anything after that.
struct AboutLine {
  std::string sweep, simulations, shards;

  static std::optional<AboutLine> read(std::string_view text) {
    LineScanner line(text);
    AboutLine about;
    if (!line.pass("# Sweep ")) return std::nullopt;
    about.sweep = line.takeUntil(" \t\n\v\f\r");
    if (about.sweep.size() < 2 || about.sweep.back() != ':' || !line.pass(" ")) return std::nullopt;
    about.sweep.pop_back();
    about.simulations = line.digits();
    if (about.simulations.empty() || !line.pass(" simulations dealt to ")) return std::nullopt;
    about.shards = line.digits();
    if (about.shards.empty() || !line.pass(" shards.") || !line.endsAnyhow()) return std::nullopt;
    return about;
  }
};

/// "#SBATCH --array=1-N", perhaps with a throttle.
struct ArrayLine {
  std::string last, throttle;

  static std::optional<ArrayLine> read(std::string_view text) {
    LineScanner line(text);
    ArrayLine array;
    if (!line.pass("#SBATCH --array=1-")) return std::nullopt;
    array.last = line.digits();
    if (line.pass("%")) {
      array.throttle = "%" + line.digits();
      if (array.throttle == "%") return std::nullopt;
    }
    if (array.last.empty() || !line.ends()) return std::nullopt;
    return array;
  }
};

/// The digits that follow `start` at the end of the line.
std::optional<std::string> digitsAfter(std::string_view start, std::string_view text) {
  LineScanner line(text);
  if (!line.pass(start)) return std::nullopt;
  std::string digits = line.digits();
  if (digits.empty() || !line.ends()) return std::nullopt;
  return digits;
}

std::optional<std::string> readCpus(std::string_view line) {
  return digitsAfter("#SBATCH --cpus-per-task=", line);
}

std::optional<std::string> readShards(std::string_view line) {
  return digitsAfter("shards=", line);
}

/// What follows "program=".
std::optional<std::string> readProgram(std::string_view text) {
  LineScanner line(text);
  if (!line.pass("program=") || !line.endsAnyhow()) return std::nullopt;
  return line.rest();
}

/// Where the first line stands that `read` takes, and what it says.
template <typename Value>
struct FoundLine {
  std::size_t at = 0, length = 0;
  Value value;
};

template <typename Read>
auto findLine(const std::string& text, const Read& read)
    -> std::optional<FoundLine<typename decltype(read(text))::value_type>> {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (auto value = read(std::string_view(text).substr(at, end - at))) return {{at, end - at, *value}};
    at = end + 1;
  }
  return std::nullopt;
}

std::size_t numberOf(const std::string& digits) {
  return digits.size() > 9 ? 999999999 : std::stoul(digits);
}

template <typename Read>
void replaceLine(std::string& text, const Read& read, const std::string& by) {
  if (const auto line = findLine(text, read)) text.replace(line->at, line->length, by);
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
  const auto need = [&](const auto& read, const char* expected) {
    const auto line = findLine(text, read);
    if (!line)
      throw InputError(
          inFile(file),
          fmt::format("has no line {}, expected it as it was written, or no file, to have it written anew",
                      expected));
    return line->value;
  };
  ArrayScript script;
  const AboutLine about = need(AboutLine::read, "\"# Sweep NAME: M simulations dealt to N shards.\"");
  script.sweep = about.sweep;
  script.simulations = numberOf(about.simulations);
  const ArrayLine array = need(ArrayLine::read, "#SBATCH --array=1-N");
  script.throttle = array.throttle;
  script.cpus = numberOf(need(readCpus, "#SBATCH --cpus-per-task=N"));
  script.shards = numberOf(need(readShards, "shards=N"));
  script.program = need(readProgram, "program='...'");
  if (script.shards == 0) throw InputError(inFile(file), "shards=0, expected at least 1");
  if (numberOf(array.last) != script.shards)
    throw InputError(
        inFile(file),
        fmt::format("--array=1-{} with {}, expected the same number in both; to change it, --shards N",
                    array.last, shardsLine(script)));
  return script;
}

std::string withShards(std::string text, const ArrayScript& script) {
  replaceLine(text, AboutLine::read, aboutLine(script));
  replaceLine(text, ArrayLine::read, arrayLine(script));
  replaceLine(text, readShards, shardsLine(script));
  return text;
}

bool isUneditedMergeScript(const std::string& text, const std::string& sweep) {
  const auto program = findLine(text, readProgram);
  return program && text == mergeScriptText(sweep, program->value);
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
  if (ranges.size() > longest) return fmt::format("{}-{}", indices.front(), indices.back());
  return ranges;
}

}  // namespace fissure
