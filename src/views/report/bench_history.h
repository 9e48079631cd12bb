#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace fissure {

/// One benchmark of one commit on one machine.
struct BenchCase {
  std::vector<double> times_us;            ///< of a call, one per repetition
  std::map<std::string, double> counters;  ///< of a call
};

/// Where a commit was measured; times of two machines do not compare.
struct BenchMachine {
  std::string cpu, compiler, flags;
  int cores = 0;
  bool operator==(const BenchMachine&) const = default;
  bool operator<(const BenchMachine& other) const {
    return std::tie(cpu, compiler, flags, cores) <
           std::tie(other.cpu, other.compiler, other.flags, other.cores);
  }
};

/// A commit; with `modified`, one whose files were changed. In the order of dates.
struct BenchCommit {
  std::string date;  ///< UTC, "2026-01-31T12:00:00Z"
  std::string commit;
  bool modified = false;
  bool operator==(const BenchCommit&) const = default;
  bool operator<(const BenchCommit& other) const {
    return std::tie(date, commit, modified) < std::tie(other.date, other.commit, other.modified);
  }
};

/// A file of scripts/bench (bench/README.md).
struct BenchFile {
  BenchCommit commit;
  BenchMachine machine;
  std::map<std::string, BenchCase> cases;  ///< by name
};

/// Throws InputError about a file that is none, damaged, or of a newer version.
BenchFile readBenchFile(const std::filesystem::path& file);

/// What a folder holds of the history of benchmarks.
struct BenchHistory {
  std::vector<BenchFile> files;  ///< one per commit and machine, the oldest commit first
  struct Problem {
    std::string file;  ///< below the folder
    std::string text;  ///< one line
  };
  std::vector<Problem> problems;  ///< files that are not shown, and why
};

/// The *.json files in a folder, not below it, by name.
std::vector<std::filesystem::path> benchFilesIn(const std::filesystem::path& folder);

/// Reads all of them. Throws InputError, with the reason of the first, when none can be shown.
BenchHistory readBenchHistory(const std::filesystem::path& folder);

/// A change of a benchmark's time between two commits on one machine.
struct BenchStep {
  std::size_t at = 0;  ///< index of the first commit with the new time
  double ratio = 1;    ///< median after it over median before it
  double p = 1;        ///< of the U test
};

inline constexpr double step_relative = 0.05;    ///< least change of the median, of that before
inline constexpr double step_absolute_us = 0.5;  ///< least change of the median
inline constexpr double step_p = 0.02;           ///< largest p of the U test
inline constexpr std::size_t step_before = 3;    ///< most commits before that are looked at
inline constexpr std::size_t step_after = 2;     ///< and from the step on: what lasts no longer is none

/// The steps in `times_us`, [commit][repetition], none of them empty, oldest first: at a commit whose median,
/// and those of the commits looked at after it, all differ from the median before by more than both limits
/// into one direction, with p of a two-sided U test over all repetitions (normal approximation with
/// correction for continuity) below step_p. What lies before a step is not looked at after it.
std::vector<BenchStep> findSteps(const std::vector<std::vector<double>>& times_us);

/// Two-sided p of Mann and Whitney's U test, in that approximation; ties count one half.
double uTest(const std::vector<double>& one, const std::vector<double>& other);

/// The value below which a share of the values lies, between neighbours linearly. `values`: not empty.
double quantile(std::vector<double> values, double share);

}  // namespace fissure
