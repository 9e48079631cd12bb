#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/tradeoff_answer.h"

namespace fissure {

/// Writes `<folder>/tradeoff.csv`, a line for each setting, and `<folder>/tradeoff.json`, all that the study
/// found, references and answers included; `command` of a setting repeats its run into a result of its own.
/// Each is replaced completely or not at all. Missing numbers are empty in the one and null in the other.
/// Throws RunError when writing fails.
void writeTradeoff(const std::filesystem::path& folder, const TradeoffStudy& study,
                   const TradeoffResult& result, const std::vector<TradeoffAnswer>& answers,
                   CostMeasure cost);

/// The contents of the two files.
std::string tradeoffCsv(const TradeoffStudy& study, const TradeoffResult& result);
std::string tradeoffJson(const TradeoffStudy& study, const TradeoffResult& result,
                         const std::vector<TradeoffAnswer>& answers, CostMeasure cost);

}  // namespace fissure
