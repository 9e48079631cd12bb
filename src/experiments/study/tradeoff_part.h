#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/run_status.h"
#include "process/interrupt.h"
#include "process/progress_display.h"
#include "study/tradeoff_points.h"
#include "sweep/sweep_plan.h"
#include "sweep/sweep_session.h"

namespace fissure {

/// What became of one setting, or one rung, with one pipeline.
struct TradeoffRun {
  std::size_t point = 0;       ///< index in the points of the part
  std::string pipeline;        ///< name of the run
  RunStatus status;            ///< that of the first repeat that did not end well
  std::filesystem::path file;  ///< its result; empty where there is none
  /// The numbers of `timing/`, one of each repeat that ended well, without that prefix.
  std::map<std::string, std::vector<double>> timing;
};

/// One of the sweeps of a study: `<study's folder>/<name>.yaml` and its folder `<study's folder>/<name>`,
/// which are a sweep like any other.
class StudyPart {
 public:
  /// Writes the sweep and plans it. Throws InputError, about the study's file where an axis is to blame, and
  /// leaves an earlier sweep as it was; RunError when writing fails.
  StudyPart(const TradeoffStudy& study, const std::string& name, const std::filesystem::path& folder,
            const std::filesystem::path& base, const std::vector<std::string>& pipelines,
            const StudyPoints& points, int repeats);

  const std::string& name() const { return name_; }
  const SweepPlan& plan() const { return *plan_; }
  /// What is left to do of share `index` of `count`, repeat by repeat: each repeat takes the settings in
  /// turns, every other one backwards, so that no setting has a part of the day to itself.
  std::vector<std::size_t> unfinished(std::size_t index, std::size_t count) const;

  struct Settings {
    int slots = 1;
    std::string command_line;
  };
  /// Runs these. What has ended before a failure or an interrupt is kept.
  SessionCounts run(const std::vector<std::size_t>& tasks, const Settings& settings, Interrupt& interrupt,
                    ProgressDisplay& display) const;

  /// What is known of all points and pipelines, in the order of the points; points that make no difference to
  /// a run share one.
  std::vector<TradeoffRun> runs() const;

 private:
  std::string name_;
  std::filesystem::path folder_;
  std::unique_ptr<SweepPlan> plan_;
};

}  // namespace fissure
