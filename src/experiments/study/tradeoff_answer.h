#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenario/load.h"
#include "study/tradeoff_result.h"

namespace fissure {

/// What a user wants of a setting.
struct TradeoffWish {
  std::string name;                 ///< "budget" or "errors": that of its scenario file
  std::optional<double> budget_us;  ///< the most that a simulated millisecond may cost
  std::vector<ErrorLimit> limits;   ///< the largest errors; with them no budget

  std::string text() const;  ///< "at most 1000 us for a simulated millisecond", "depth at most 100 um"
};

/// The setting that fulfils a wish.
struct TradeoffAnswer {
  TradeoffWish wish;
  Choice choice;                       ///< indices in TradeoffResult::settings
  std::filesystem::path file;          ///< the scenario that was written; empty: none
  std::optional<JudgedSetting> again;  ///< what that scenario cost and erred when run again
  bool holds = false;                  ///< it was within the wish when run again
};

/// Throws InputError about a limit of what the study does not judge.
void refuseUnjudged(const TradeoffStudy& study, const std::vector<ErrorLimit>& limits);

/// Chooses the setting. Within a budget must be the upper quartile of its cost, so that it is so again.
TradeoffAnswer answerOf(const TradeoffWish& wish, const TradeoffStudy& study, const TradeoffResult& result,
                        CostMeasure cost);

/// Whether a setting is within a wish, a budget in the median of its cost.
bool fulfils(const JudgedSetting& setting, const TradeoffWish& wish, const TradeoffStudy& study,
             const TradeoffResult& result, CostMeasure cost);

/// The answer in one line or two, for people.
std::string answerText(const TradeoffAnswer& answer, const TradeoffStudy& study, const TradeoffResult& result,
                       CostMeasure cost);

/// The setting as "swept with subdivisions 2".
std::string settingText(const JudgedSetting& setting, const TradeoffResult& result);

/// What the setting changes of the study's scenario.
std::vector<Override> overridesOf(const JudgedSetting& setting, const TradeoffResult& result);

}  // namespace fissure
