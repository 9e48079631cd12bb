#pragma once

#include <string>
#include <vector>

#include "study/tradeoff_result.h"

namespace fissure {

/// The settings as rows of a table, its header first: values, run, cost with its spread, errors, "front" or
/// why there is no number. All columns are texts.
std::vector<std::vector<std::string>> settingRows(const TradeoffStudy& study, const TradeoffResult& result);

/// What each reference is worth, and which are refused and why, a line each.
std::vector<std::string> referenceLines(const TradeoffStudy& study, const TradeoffResult& result);

/// How errors grow along axes, a line each.
std::vector<std::string> orderLines(const TradeoffStudy& study, const TradeoffResult& result);

}  // namespace fissure
