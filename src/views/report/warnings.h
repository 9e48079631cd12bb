#pragma once

#include <vector>

#include "report/report_run.h"

namespace fissure {

/// What a reader must know before believing the rest, the serious first: {serious, runs: [run], text}; `runs`
/// is empty where it is about the whole result. What several runs share stands there once. Throws InputError
/// when a series cannot be read.
PageJson warningsJson(const ResultInfo& info, const std::vector<ReportRun>& runs);

/// A warning about a result as a whole that somebody else found.
PageJson resultWarning(bool serious, const std::string& text);

}  // namespace fissure
