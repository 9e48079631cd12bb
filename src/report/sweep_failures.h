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

/// How the runs of a sweep ended, all of them.
struct SweepEnds {
  std::vector<std::string> status;   ///< one a run
  std::vector<std::size_t> reasons;  ///< one a run, of `failures`; failures.size() where it has not failed
  PageJson failures;  ///< [{status, reason, count, examples: [run], pipelines: [[name, count]], where:
                      ///< [{axis, from, to, share}]}], the most frequent first
};

/// Status of runs that nobody has run yet, and of those that are as they should be; all others have failed.
inline constexpr const char* missing_run = "missing";
inline constexpr const char* good_run = "ok";

/// `where`: up to three axes along which the failed runs lie between `from` and `to`, and at most three
/// quarters (`share`) of all runs of the same pipelines do.
SweepEnds sweepEnds(const SweepTable& table);

}  // namespace fissure
