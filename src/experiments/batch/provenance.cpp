#include "batch/provenance.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include "base/error.h"
#include "base/hash.h"
#include "batch/build_info.h"
#include "files/input_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// Cuts an absolute path in `word` (alone, after '=' or after a short option) down to its file name.
std::string withoutFolders(const std::string& word) {
  std::size_t slash = word.find('/');
  const bool absolute =
      slash == 0 || (slash != std::string::npos && word[slash - 1] == '=') || (slash == 2 && word[0] == '-');
  if (!absolute) return word;
  const fs::path path = word.substr(slash);
  return word.substr(0, slash) + path.filename().string();
}

std::string quoted(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text(1, '\'');
  for (const char c : word) {
    if (c == '\'') text += "'\\'";  // ends the quotes, adds one, begins them again with the next character
    text += c;
  }
  return text += '\'';
}

std::string utc(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm parts = {};
  gmtime_r(&seconds, &parts);
  std::array<char, 32> text = {};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

/// The rest of the first line of `file` that starts with `key`, after its separator; "unknown" where there is
/// none.
std::string valueIn(const fs::path& file, const std::string& key, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key)) continue;
    std::string value = line.substr(std::min(line.size(), line.find(separator) + 1));
    value.erase(0, value.find_first_not_of(" \t\""));
    while (!value.empty() && (value.back() == '"' || value.back() == ' ')) value.pop_back();
    return value;
  }
  return "unknown";
}

std::string seconds(double value) {
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}

}  // namespace

std::optional<std::string> fileHash(const fs::path& file) try {
  return "sha256:" + sha256(readInputFile(file, "a file"));
} catch (const InputError&) {
  return std::nullopt;
}

std::string inputHashes(const LoadedScenario& loaded) {
  const fs::path folder = fs::absolute(loaded.scenario.directory).lexically_normal();
  std::string text;
  for (const fs::path& input : loaded.inputs) {
    const fs::path full = fs::absolute(input).lexically_normal();
    fs::path name = full.lexically_relative(folder);
    if (name.empty() || *name.begin() == "..") name = full.filename();
    const std::optional<std::string> hash = fileHash(input);
    if (!hash) throw RunError(input.string() + ": cannot be read any more");
    text += (text.empty() ? "" : ", ") + name.generic_string() + "=" + *hash;
  }
  return text;
}

std::string commandLine(int argc, const char* const* argv) {
  std::string text = "fissure";
  for (int i = 1; i < argc; ++i) text.append(1, ' ').append(quoted(withoutFolders(argv[i])));
  return text;
}

Provenance collectProvenance(const LoadedScenario& loaded, const std::string& input_hashes,
                             const std::string& command_line, const RunTimes& times) {
  const BuildInfo& build = buildInfo();
  return {{"version", build.version},
          {"commit", build.commit},
          {"dirty", build.dirty ? "true" : "false"},
          {"scenario_hash", "sha256:" + sha256(loaded.resolved)},
          {"input_hashes", input_hashes},
          {"command_line", command_line},
          {"started_utc", utc(times.started)},
          {"ended_utc", utc(times.ended)},
          {"wall_time_s", seconds(times.wall_s)},
          {"cpu_model", valueIn("/proc/cpuinfo", "model name", ':')},
          {"cpu_count", std::to_string(std::thread::hardware_concurrency())},
          {"os", valueIn("/etc/os-release", "PRETTY_NAME=", '=')},
          {"compiler", build.compiler},
          {"compiler_flags", build.flags},
          {"build_type", build.build_type},
          {"hdf5_version", hdf5Version()},
          {"yaml_cpp_version", build.yaml_cpp_version},
          {"seed", "none: nothing is random"}};
}

Provenance salvageProvenance(const LoadedScenario& loaded, const std::string& command_line) {
  const BuildInfo& build = buildInfo();
  return {{"version", build.version},
          {"commit", build.commit},
          {"dirty", build.dirty ? "true" : "false"},
          {"scenario_hash", "sha256:" + sha256(loaded.resolved)},
          {"command_line", command_line},
          {"hdf5_version", hdf5Version()},
          {"yaml_cpp_version", build.yaml_cpp_version}};
}

}  // namespace fissure
