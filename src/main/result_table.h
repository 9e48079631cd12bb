#pragma once

#include <string>
#include <vector>

#include "store/result_file.h"

namespace fissure {

/// The table at the end of `run` and in `info`: one line a pipeline, columns aligned, under a header of three
/// lines, how the run ended first and what its measures say of it last. A number that the result does not
/// have is "-", one that is not a number "nan"; below it one line for each run that did not finish, for each
/// law whose force was not finite, and for what must be known beside the numbers (remarksOf, reactionNote).
std::string resultTable(const std::vector<PipelineResult>& pipelines);

/// A summary value as text, numbers in full.
std::string summaryText(const SummaryValue& value);

}  // namespace fissure
