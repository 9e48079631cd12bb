#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/compare_runs.h"

namespace fissure {

/// A result file, or one run of it, as named by the user.
struct ResultChoice {
  std::filesystem::path file;
  std::string run;  ///< empty: all
};

/// Parses "FILE" or "FILE:NAME". An existing file whose own name ends with ":NAME" takes precedence.
ResultChoice parseChoice(const std::string& text);

/// The comparison of two results, run by run.
struct ResultComparison {
  ResultChoice a, b;
  std::vector<RunComparison> runs;
  std::vector<std::string> problems;  ///< runs that only one of them has
  /// "the scenarios differ, first in ...".
  std::vector<std::string> notes;

  bool agrees() const;
};

/// Pairs the runs of two results by name, or the two runs that were named, and compares them. The infos must
/// outlive the comparison. Throws InputError when a named run does not exist.
ResultComparison compareResults(const ResultChoice& a, const ResultInfo& info_a, const ResultChoice& b,
                                const ResultInfo& info_b, const CompareSettings& settings);

/// The comparison as text for people; `all`: with quantities that are equal or within tolerance.
std::string comparisonText(const ResultComparison& comparison, bool all);
/// The comparison for programs.
nlohmann::ordered_json comparisonJson(const ResultComparison& comparison);

}  // namespace fissure
