#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/tradeoff_choice.h"
#include "study/tradeoff_curve.h"
#include "study/tradeoff_file.h"
#include "study/tradeoff_ladder.h"
#include "study/tradeoff_part.h"
#include "study/tradeoff_read.h"

namespace fissure {

/// What the ladder says of one quantity of the reference.
struct JudgedReference {
  std::string pipeline;             ///< name of the run that was refined
  std::size_t error = 0;            ///< index in the study's errors
  std::vector<double> differences;  ///< between neighbouring rungs, in the error's measure
  Refinement refinement;
  double peak = std::numeric_limits<double>::quiet_NaN();        ///< of the finest rung
  double peak_limit = std::numeric_limits<double>::quiet_NaN();  ///< Richardson's estimate of that peak
  double tolerance = std::numeric_limits<double>::quiet_NaN();   ///< in the unit of the quantity
};

/// Cost of a setting over its repeats, without settling. Times are those of the step, without measuring and
/// writing; processor time and memory are those of the worker as a whole.
struct SettingCost {
  Spread us_per_step, p99_us_per_step;
  Spread us_per_ms, p99_us_per_ms;  ///< the same for each simulated millisecond
  Spread processor_s_per_s;
  Spread memory_mib;
};

/// One setting with one pipeline.
struct JudgedSetting {
  std::vector<std::string> values;  ///< one per path
  std::string pipeline;
  RunStatus status;
  std::filesystem::path file;
  SettingCost cost;
  std::vector<CurveError> differences;  ///< one for each of the study's errors; NaN: cannot be compared
  std::vector<double> errors;  ///< of these the measure that counts; NaN too where there is no reference
  /// The largest error over its tolerance, none taken as smaller than the reference's own; NaN where one is.
  double score = std::numeric_limits<double>::quiet_NaN();
  bool front = false;
};

/// How one error grows along one group of axes, over all lines on which nothing else varies.
struct AxisOrder {
  std::string path;  ///< the group's first axis
  std::string pipeline;
  std::size_t error = 0;
  Spread order;
  std::size_t lines = 0;
};

enum class CostMeasure { mean, p99 };

struct TradeoffResult {
  std::vector<std::string> paths;
  std::vector<JudgedReference> references;
  std::vector<JudgedSetting> settings;
  std::vector<AxisOrder> orders;

  /// The reference of a setting in an error; null where there is none.
  const JudgedReference* referenceOf(const std::string& pipeline, std::size_t error) const;
};

/// The finest rungs, by the name of their run: what settings are compared with.
using FinestRungs = std::map<std::string, StudyRecord>;

/// Judges the ladder. `rungs`: its runs, from StudyPart::runs(). `finest` gets the records of the finest.
std::vector<JudgedReference> judgeLadder(const TradeoffStudy& study, const std::vector<TradeoffRun>& rungs,
                                         FinestRungs& finest);

/// Judges one run of a setting against the references.
JudgedSetting judgeSetting(const TradeoffStudy& study, const TradeoffRun& run,
                           const std::vector<std::string>& values, const TradeoffResult& result,
                           const FinestRungs& finest);

/// Judges all: references, settings, front and orders.
TradeoffResult judgeStudy(const TradeoffStudy& study, const StudyPart& settings, const StudyPart& ladder,
                          CostMeasure cost);

/// The cost by which settings are chosen, for a simulated millisecond, over repeats.
const Spread& costOf(const JudgedSetting& setting, CostMeasure measure);

/// The largest error over its limit, each with the reference's own error added; NaN where one is not known.
double excessOf(const JudgedSetting& setting, const TradeoffStudy& study, const TradeoffResult& result,
                const std::vector<ErrorLimit>& limits);

/// Marks the front of cost and score.
void markFront(std::vector<JudgedSetting>& settings, CostMeasure cost);

/// How errors grow along the axes whose values are numbers.
std::vector<AxisOrder> ordersOf(const TradeoffStudy& study, const TradeoffResult& result);

}  // namespace fissure
