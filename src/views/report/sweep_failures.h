#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/report_run.h"
#include "table/sweep_table.h"

namespace fissure {

/// A reason with its numbers written as "#", so that equal causes at different times are equal: "at step 512"
/// becomes "at step #". Digits within names ("hc2") stay.
std::string withoutNumbers(const std::string& reason);

/// Where along an axis failed runs lie, and what share of all runs of the same pipelines does.
struct FailurePlace {
  std::string axis;
  double from = 0;                 ///< of a numeric axis
  double to = 0;                   ///< of a numeric axis
  std::vector<std::string> texts;  ///< of an axis of texts: the values at which they failed, sorted
  double share = 0;
};

/// Runs that ended alike.
struct SweepFailure {
  RunEnd end = RunEnd::failed;
  std::string reason;  ///< without numbers
  std::vector<std::size_t> runs;
  /// Up to three axes, the smallest share first: numeric ones with a share of at most three quarters, and
  /// those of texts where not all values failed.
  std::vector<FailurePlace> where;
};

/// How the runs of a sweep ended, all of them.
struct SweepEnds {
  std::vector<std::string> pipelines;  ///< one a run
  std::vector<RunEnd> ends;            ///< one a run
  std::vector<std::size_t> reasons;    ///< one a run, of `failures`; failures.size() where it has not failed
  /// Runs that ended otherwise than `ok`, without those that nobody has run yet; the most frequent first.
  std::vector<SweepFailure> failures;
};

SweepEnds sweepEnds(const SweepTable& table);

/// [{status, reason, count, examples: [run], pipelines: [[name, count]], where: [{axis, from, to, share}]}];
/// of an axis of texts instead of from and to: values, up to a dozen, and more, the number of the others.
PageJson failuresJson(const SweepEnds& ends);

}  // namespace fissure
