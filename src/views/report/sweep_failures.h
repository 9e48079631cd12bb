#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/report_run.h"
#include "table/sweep_table.h"

namespace fissure {

/// A reason with its numbers replaced by "#", so that equal causes at different times have equal texts: "at
/// step 512" becomes "at step #". Digits within names ("hc2") stay.
std::string withoutNumbers(const std::string& reason);

/// The range of failed runs along an axis, and the share of all runs of the same pipelines that lie in this
/// range.
struct FailurePlace {
  std::string axis;
  double from = 0;                 ///< bound of the range, for a numeric axis
  double to = 0;                   ///< bound of the range, for a numeric axis
  std::vector<std::string> texts;  ///< for an axis of texts: the values with failed runs, sorted
  double share = 0;
};

/// Runs that failed for the same reason.
struct SweepFailure {
  RunEnd end = RunEnd::failed;
  std::string reason;  ///< without numbers
  std::vector<std::size_t> runs;
  /// Up to three axes, the smallest share first: numeric axes with a share of at most three quarters, and
  /// axes of texts with values at which no run failed.
  std::vector<FailurePlace> where;
};

/// How all runs of a sweep ended.
struct SweepEnds {
  std::vector<std::string> pipelines;  ///< one per run
  std::vector<RunEnd> ends;            ///< one per run
  /// One per run: index in `failures`, or failures.size() where it has not failed.
  std::vector<std::size_t> reasons;
  /// Runs with another end than `ok`, without those not run yet; the most frequent first.
  std::vector<SweepFailure> failures;
};

SweepEnds sweepEnds(const SweepTable& table);

/// [{status, reason, count, examples: [run], pipelines: [[name, count]], where: [{axis, from, to, share}]}].
/// An axis of texts has, instead of from and to, `values`, up to a dozen, and `more`, the number of further
/// ones.
PageJson failuresJson(const SweepEnds& ends);

}  // namespace fissure
