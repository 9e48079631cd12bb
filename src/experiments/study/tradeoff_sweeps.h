#pragma once

#include <filesystem>

#include "study/tradeoff_answer.h"
#include "study/tradeoff_part.h"
#include "study/tradeoff_result.h"

namespace fissure {

/// The simulations of a study: its settings, the ladder of its reference, and answers run again.
class StudySweeps {
 public:
  /// Plans settings and ladder in `folder`. Throws InputError about what the study and its scenario do not
  /// fit, and as StudyPart does; a folder that was not there before is then gone again.
  StudySweeps(TradeoffStudy study, std::filesystem::path folder);

  const TradeoffStudy& study() const { return study_; }
  const std::filesystem::path& folder() const { return folder_; }
  const StudyPart& settings() const { return settings_; }
  const StudyPart& ladder() const { return ladder_; }

  /// Judges what has been simulated.
  TradeoffResult judge(CostMeasure cost) const;

  /// Writes the scenario of an answer's best setting, `<folder>/<wish>.yaml`, and names it in the answer.
  void writeScenario(TradeoffAnswer& answer, const TradeoffResult& result, CostMeasure cost) const;
  /// Plans that scenario to be run again, as often as the study repeats, forgetting earlier times.
  StudyPart planAgain(const TradeoffAnswer& answer, const TradeoffResult& result) const;
  /// Judges what it cost and erred, and whether it was within the wish.
  void judgeAgain(TradeoffAnswer& answer, const StudyPart& again, const TradeoffResult& result,
                  CostMeasure cost) const;

 private:
  /// Removes what is below a folder that was not there, unless that is wanted.
  struct NewFolder {
    std::filesystem::path top;  ///< of the folders to be made; empty: there are none
    ~NewFolder();
  };

  std::filesystem::path base() const;
  std::vector<std::string> referencePipelines() const;

  TradeoffStudy study_;
  std::filesystem::path folder_;
  NewFolder new_folder_;
  StudyPart settings_;
  StudyPart ladder_;
};

}  // namespace fissure
