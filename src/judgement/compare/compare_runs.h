#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/difference.h"
#include "scenario/tolerances.h"
#include "store/result_file.h"

namespace fissure {

/// Settings of a comparison of two runs.
struct CompareSettings {
  Tolerances tolerances;
  bool exact = false;         ///< demand equality bit for bit, whatever the tolerances
  double max_shift_s = 0.02;  ///< largest shift in time that is searched for
};

/// The comparison of one quantity of two runs A and B. Summary values are quantities too, as
/// "summary/max_force_N".
struct QuantityComparison {
  std::string quantity;
  std::string units;
  /// A defect that no tolerance allows: missing, another unit, length or axis, NaN; else empty.
  std::string problem;
  Difference difference;
  /// Place of the largest difference: "step 57 (0.057 s), hc, y".
  std::string worst_at;
  std::string first_at;   ///< place of the first difference
  std::string beyond_at;  ///< place of the first row beyond the tolerance
  std::optional<TimeShift> shift;
  double shift_s = 0;  ///< delay of A against B
  ToleranceRule tolerance;
  std::optional<double> scalar_a, scalar_b;  ///< values, for a summary value that is a number
  std::string text_a, text_b;                ///< values, for a summary value that is a text
  bool agrees = false;

  bool equal() const { return problem.empty() && difference.count == 0 && text_a == text_b; }
};

/// A run in a result file.
struct RunOfFile {
  std::filesystem::path file;
  const ResultInfo* info = nullptr;
  const PipelineResult* run = nullptr;

  std::string label() const { return file.string() + ":" + run->name; }
};

struct RunComparison {
  RunOfFile a, b;
  std::vector<std::string> problems;  ///< problems of the runs as a whole: one failed, other precision
  std::vector<QuantityComparison> quantities;

  bool agrees() const;
};

/// Compares all quantities of two runs except timing/ and provenance. Where B is a reference, A is compared
/// at the times that B has, without pictures. Throws InputError when a file cannot be read.
RunComparison compareRuns(const RunOfFile& a, const RunOfFile& b, const CompareSettings& settings);

/// Whether NaN has a meaning in this quantity ("no contact", "not measured"), so that NaN in both runs counts
/// as equal. In other quantities NaN is a failure, even in both.
bool mayBeMissing(const std::string& quantity);

}  // namespace fissure
