#include "slurm/sbatch_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "base/error.h"

namespace fissure {

namespace {

struct Option {
  char letter = ' ';
  std::string_view name;
  std::size_t least = 0;  ///< so many letters of the name are enough for sbatch
};

constexpr Option output = {'o', "--output", 4};

struct Unfit {
  Option option;
  const char* variable =
      "";  ///< of the environment, which says the same; "": there is none, or it is overridden
  const char* expected = "";
};

constexpr std::array<Unfit, 4> unfit = {{
    {{'a', "--array", 4},
     "",
     "the array is chosen here, expected --shards; for eight tasks at a time append %8 to --array in "
     "slurm/array.sbatch"},
    {{'c', "--cpus-per-task", 12}, "", "the CPUs of a shard are chosen here, expected -j before the --"},
    {{'M', "--clusters", 4},
     "SBATCH_CLUSTERS",
     "the queue and the limits of one cluster are asked, expected a machine of the cluster to submit to"},
    {{'W', "--wait", 6}, "SBATCH_WAIT", "the merge is submitted while the shards wait, expected no waiting"},
}};

constexpr std::string_view letters_without_value = "hHIkOQsuvV";

bool isLong(std::string_view word, const Option& option) {
  const std::string_view name = word.substr(0, word.find('='));
  return name.size() >= option.least && option.name.starts_with(name);
}

/// Also among letters that stand together.
bool isShort(std::string_view word, const Option& option) {
  if (word.size() < 2 || word[0] != '-' || word[1] == '-') return false;
  const std::size_t last = word.find_first_not_of(letters_without_value, 1);
  return last != std::string_view::npos && word[last] == option.letter;
}

bool is(std::string_view word, const Option& option) {
  return isLong(word, option) || isShort(word, option);
}

/// sbatch takes the first word that is no option and no value of one for the job's script.
void refuseScript(const std::string& word, const std::string& before) {
  const bool may_be_value = before.size() > 1 && before[0] == '-' && before.find('=') == std::string::npos;
  std::error_code ignored;
  if (word == "-" || word == "--" || !may_be_value)
    throw InputError(fmt::format(
        "-- {}: is no option of sbatch, expected options alone, because the script is that of the sweep",
        word));
  if (std::filesystem::is_regular_file(word, ignored))
    throw InputError(
        fmt::format("-- {0} {1}: names a file, which sbatch could take for the script, expected it behind a "
                    "= (--option={1})",
                    before, word));
}

}  // namespace

bool nameOutput(const std::vector<std::string>& options) {
  return std::any_of(options.begin(), options.end(),
                     [](const std::string& word) { return is(word, output); });
}

void refuseUnfitOptions(const std::vector<std::string>& options) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string& word = options[i];
    if (!word.starts_with('-') || word == "-" || word == "--")
      refuseScript(word, i == 0 ? "" : options[i - 1]);
    for (const Unfit& each : unfit)
      if (is(word, each.option)) throw InputError(fmt::format("-- {}: {}", word, each.expected));
  }
  for (const Unfit& each : unfit)
    if (*each.variable && std::getenv(each.variable))
      throw InputError(fmt::format("{} is set: {}", each.variable, each.expected));
}

}  // namespace fissure
