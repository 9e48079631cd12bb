#pragma once

#include <string>
#include <vector>

#include "store/result_file.h"

namespace fissure {

/// The table at the end of `fissure run` and in `fissure info`: one line per run under a header of three
/// lines, with the end of the run as the first column and its verdict as the last. A number that the result
/// does not have is "-", NaN is "nan". Below the table stands one line for each run that did not finish, for
/// each law whose force was not finite, and for each remark (remarksOf, reactionNote).
std::string resultTable(const std::vector<PipelineResult>& pipelines);

/// All numbers of the summaries: one line per quantity with a column per run, six digits, "-" where a run has
/// none.
std::string summaryTable(const std::vector<PipelineResult>& pipelines);

/// A summary value as text, numbers with all digits.
std::string summaryText(const SummaryValue& value);

}  // namespace fissure
