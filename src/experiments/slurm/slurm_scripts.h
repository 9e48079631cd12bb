#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace fissure {

/// The generated values in `<sweep's folder>/slurm/array.sbatch`. The file has no paths of folders: jobs
/// start in the sweep's folder, which can be moved.
struct ArrayScript {
  std::string sweep;            ///< name of the sweep
  std::size_t simulations = 1;  ///< number of simulations in the plan
  std::size_t shards = 1;       ///< number of array tasks, counted from 1
  std::size_t cpus = 1;         ///< CPUs per shard: simulations at the same time
  std::string program;          ///< path of this program, as a word of the shell
  /// Limit of shards at the same time in an edited file, as "%8".
  std::string throttle;
};

/// `<folder>/slurm`, and its files.
std::filesystem::path slurmFolder(const std::filesystem::path& folder);
std::filesystem::path arrayScriptFile(const std::filesystem::path& folder);
std::filesystem::path mergeScriptFile(const std::filesystem::path& folder);

/// `text` as one word of the shell, in quotes where it needs them.
std::string shellWord(const std::string& text);

/// The texts of both files, to be read and edited by people.
std::string arrayScriptText(const ArrayScript& script);
std::string mergeScriptText(const std::string& sweep, const std::string& program);

/// Reads the values from an array script, edited or not. Throws InputError about `file` that names the
/// missing line.
ArrayScript readArrayScript(const std::string& text, const std::filesystem::path& file);
/// The same text with the numbers of shards and simulations from `script`, otherwise unchanged.
std::string withShards(std::string text, const ArrayScript& script);
/// Whether a merge script is unchanged since mergeScriptText() wrote it, for this or another program.
bool isUneditedMergeScript(const std::string& text, const std::string& sweep);

/// Ascending indices of shards in the syntax of sbatch: "1,4-7". Where this would be thousands of numbers,
/// the range from the first to the last: shards that miss nothing end at once.
std::string arrayRanges(const std::vector<std::size_t>& indices);

}  // namespace fissure
