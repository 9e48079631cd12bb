#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/difference.h"
#include "scenario/tolerances.h"
#include "store/result_file.h"

namespace fissure {

struct CompareSettings {
  Tolerances tolerances;
  bool exact = false;         ///< bit for bit, whatever the tolerances say
  double max_shift_s = 0.02;  ///< how far a shift in time is looked for
};

/// One quantity of two runs A and B. Summary values are quantities too: "summary/max_force_N".
struct QuantityComparison {
  std::string quantity;
  std::string units;
  std::string problem;  ///< what no tolerance allows: missing, another unit, length or axis, NaN
  Difference difference;
  std::string worst_at;   ///< of the largest difference: "step 57 (0.057 s), hc, y"
  std::string first_at;   ///< of the first difference
  std::string beyond_at;  ///< of the first row beyond the tolerance
  std::optional<TimeShift> shift;
  double shift_s = 0;  ///< A is late by so much
  ToleranceRule tolerance;
  std::optional<double> scalar_a, scalar_b;  ///< of a summary value that is a number
  std::string text_a, text_b;                ///< of one that is a text
  bool agrees = false;

  bool equal() const { return problem.empty() && difference.count == 0 && text_a == text_b; }
};

/// One run of a result file.
struct RunOfFile {
  std::filesystem::path file;
  const ResultInfo* info = nullptr;
  const PipelineResult* run = nullptr;

  std::string label() const { return file.string() + ":" + run->name; }
};

struct RunComparison {
  RunOfFile a, b;
  std::vector<std::string> problems;  ///< of the runs as a whole: one failed, other precision
  std::vector<QuantityComparison> quantities;

  bool agrees() const;
};

/// Compares everything that two runs hold but timing/ and provenance. Where B is a reference, A is compared
/// at its times, without pictures. Throws InputError when a file cannot be read.
RunComparison compareRuns(const RunOfFile& a, const RunOfFile& b, const CompareSettings& settings);

/// Whether NaN has a meaning in this quantity ("no contact", "not measured"), so that NaN on both sides is
/// the same. Anywhere else it is a failure, on both sides too.
bool mayBeMissing(const std::string& quantity);

}  // namespace fissure
