#pragma once

#include <string>
#include <vector>

#include "scenario/scenario.h"
#include "store/result_file.h"

namespace fissure {

/// The check of an expectation of a scenario against one run.
struct CheckedExpectation {
  std::string run;
  std::string quantity;
  std::string found;  ///< the value as text, or the reason why there is none
  /// False where the quantity is missing, no number or NaN, or the run is not ok. An upper bound on depth,
  /// passing through or inversion is also false where a tool never touched tissue, unless the expectation has
  /// contact: any.
  /// "at most 0.0005", "56.1 within 0.5", "0.02 to 0.03".
  std::string expected;
  bool holds = false;
};

/// Checks each expectation against each run that it names. An expectation about a run that is not among
/// `runs` does not hold.
std::vector<CheckedExpectation> checkExpectations(const std::vector<Expectation>& expectations,
                                                  const std::vector<PipelineResult>& runs);

/// One line: "fukuhara: max_penetration_depth_m is 0.00062, expected at most 0.0005".
std::string expectationText(const CheckedExpectation& checked);

}  // namespace fissure
