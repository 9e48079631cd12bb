#pragma once

#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The warnings about a result, serious ones first: [{serious, runs: [run], text}]; `runs` is empty for a
/// warning about the whole result. A warning that several runs share is listed once. Throws InputError when a
/// series cannot be read.
PageJson warningsJson(const ResultInfo& info, const std::vector<ReportRun>& runs);

/// A warning about a result as a whole, with this text.
PageJson resultWarning(bool serious, const std::string& text);

}  // namespace fissure
