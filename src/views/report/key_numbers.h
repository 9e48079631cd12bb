#pragma once

#include <vector>

#include "report/report_run.h"
#include "scenario/scenario.h"

namespace fissure {

/// The table of runs side by side: [{label, unit, cells: [{text, bad}]}], a cell a run, "-" where a run does
/// not have the number. `bad` marks what should be 0 and is not.
PageJson keyNumbersJson(const std::vector<PipelineResult>& runs);

/// The few that a table of many results shows: its columns [{label, unit}], and the cells [[{text, bad}]] of
/// each run.
PageJson folderColumnsJson();
PageJson folderNumbersJson(const std::vector<PipelineResult>& runs);

/// Every summary value as text, in the same form, by its own name.
PageJson allNumbersJson(const std::vector<PipelineResult>& runs);

/// What a scenario expects of the runs: [{run, quantity, found, expected, holds}].
PageJson expectationsJson(const std::vector<Expectation>& expectations,
                          const std::vector<PipelineResult>& runs);

}  // namespace fissure
