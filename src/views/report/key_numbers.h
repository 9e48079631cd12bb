#pragma once

#include <vector>

#include "report/report_run.h"
#include "scenario/scenario.h"

namespace fissure {

/// The table that compares runs: [{label, unit, cells: [{text, bad}]}], one cell per run, "-" where a run
/// does not have the number. `bad` marks numbers that should be 0 and are not.
PageJson keyNumbersJson(const std::vector<PipelineResult>& runs);

/// The short table of a folder of results: its columns [{label, unit}], and for each run its cells [[{text,
/// bad}]].
PageJson folderColumnsJson();
PageJson folderNumbersJson(const std::vector<PipelineResult>& runs);

/// All summary values as texts, in the form of keyNumbersJson(), with their own names as labels.
PageJson allNumbersJson(const std::vector<PipelineResult>& runs);

/// The checked expectations of a scenario: [{run, quantity, found, expected, holds}].
PageJson expectationsJson(const std::vector<Expectation>& expectations,
                          const std::vector<PipelineResult>& runs);

}  // namespace fissure
