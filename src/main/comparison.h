#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/compare_runs.h"

namespace fissure {

/// What the user named: a result file, or one run of it.
struct ResultChoice {
  std::filesystem::path file;
  std::string run;  ///< empty: all
};

/// "FILE" or "FILE:NAME"; a file whose own name ends in ":NAME" is that file.
ResultChoice parseChoice(const std::string& text);

/// Two results, run by run.
struct ResultComparison {
  ResultChoice a, b;
  std::vector<RunComparison> runs;
  std::vector<std::string> problems;  ///< runs that only one of them has
  std::vector<std::string> notes;     ///< "the scenarios differ, first in ..."

  bool agrees() const;
};

/// Pairs the runs of two results by name, or the two that were named, and compares them. The infos must
/// outlive the comparison. Throws InputError when a named run does not exist.
ResultComparison compareResults(const ResultChoice& a, const ResultInfo& info_a, const ResultChoice& b,
                                const ResultInfo& info_b, const CompareSettings& settings);

/// For people; `all`: also what is equal or within its tolerance.
std::string comparisonText(const ResultComparison& comparison, bool all);
/// For machines.
nlohmann::ordered_json comparisonJson(const ResultComparison& comparison);

}  // namespace fissure
