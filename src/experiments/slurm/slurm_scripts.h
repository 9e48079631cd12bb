#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace fissure {

/// What the generated parts of `<sweep's folder>/slurm/array.sbatch` say. The file holds no folder's path:
/// jobs start in the sweep's folder, which can be moved.
struct ArrayScript {
  std::string sweep;            ///< its name
  std::size_t simulations = 1;  ///< of the plan
  std::size_t shards = 1;       ///< one array task each, from 1
  std::size_t cpus = 1;         ///< of a shard: simulations side by side
  std::string program;          ///< this program, as a word of the shell
  std::string throttle;         ///< "%8": so many shards at a time; of a file that somebody edited
};

/// `<folder>/slurm`, and its files.
std::filesystem::path slurmFolder(const std::filesystem::path& folder);
std::filesystem::path arrayScriptFile(const std::filesystem::path& folder);
std::filesystem::path mergeScriptFile(const std::filesystem::path& folder);

/// `text` as one word of the shell, in quotes where it needs them.
std::string shellWord(const std::string& text);

/// The whole files, to be read and edited by people.
std::string arrayScriptText(const ArrayScript& script);
std::string mergeScriptText(const std::string& sweep, const std::string& program);

/// What an array script says, edited or not. Throws InputError naming `file` and the line that is missing.
ArrayScript readArrayScript(const std::string& text, const std::filesystem::path& file);
/// The same text with the number of shards and simulations of `script`, all else as it is.
std::string withShards(std::string text, const ArrayScript& script);
/// Whether a merge script is as mergeScriptText() writes it, for this or another program.
bool isUneditedMergeScript(const std::string& text, const std::string& sweep);

/// Shards in increasing order as sbatch wants them: "1,4-7". Where that would be thousands of numbers, all
/// from the first to the last: those that miss nothing end at once.
std::string arrayRanges(const std::vector<std::size_t>& indices);

}  // namespace fissure
