#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/report_run.h"
#include "store/sweep_table.h"

namespace fissure {

/// A reason with its numbers written as "#", so that equal causes at different times are equal: "at step 512"
/// becomes "at step #". Digits within names ("hc2") stay.
std::string withoutNumbers(const std::string& reason);

/// Where along an axis failed runs lie, and what share of all runs of the same pipelines does.
struct FailurePlace {
  std::string axis;
  double from = 0;
  double to = 0;
  double share = 0;
};

/// Runs that ended alike.
struct SweepFailure {
  std::string status;
  std::string reason;  ///< without numbers
  std::vector<std::size_t> runs;
  std::vector<FailurePlace> where;  ///< up to three axes with a share of at most three quarters
};

/// How the runs of a sweep ended, all of them.
struct SweepEnds {
  std::vector<std::string> pipelines;  ///< one a run
  std::vector<std::string> status;     ///< one a run
  std::vector<std::size_t> reasons;    ///< one a run, of `failures`; failures.size() where it has not failed
  std::vector<SweepFailure> failures;  ///< the most frequent first
};

/// Status of runs that nobody has run yet, and of those that are as they should be; all others have failed.
inline constexpr const char* missing_run = "missing";
inline constexpr const char* good_run = "ok";

SweepEnds sweepEnds(const SweepTable& table);

/// [{status, reason, count, examples: [run], pipelines: [[name, count]], where: [{axis, from, to, share}]}]
PageJson failuresJson(const SweepEnds& ends);

}  // namespace fissure
