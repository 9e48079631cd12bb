#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/sweep_axes.h"

namespace fissure {

struct TradeoffStudy;

/// Settings of a study, or the rungs of its ladder: at each the values of the same places of the scenario.
struct StudyPoints {
  std::vector<std::string> paths;
  std::vector<std::vector<std::string>> values;  ///< [point][path], as YAML

  /// The index of a path; its number where there is none.
  std::size_t find(const std::string& path) const;
};

/// The points of one group of axes.
StudyPoints pointsOf(const AxisGroup& group);

/// The settings of a study by its design; the first is the one that the others are varied about.
StudyPoints settingsOf(const TradeoffStudy& study);

/// The rungs of its ladder, with every axis that the ladder leaves alone at its first value.
StudyPoints rungsOf(const TradeoffStudy& study);

/// A sweep of exactly these points that keeps results, as the text of a sweep file.
std::string sweepTextOf(const TradeoffStudy& study, const std::string& name, const std::string& base,
                        const std::vector<std::string>& pipelines, const StudyPoints& points, int repeats);

}  // namespace fissure
