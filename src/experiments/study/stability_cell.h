#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenario/load.h"
#include "study/stability_file.h"

namespace fissure {

/// A cell as a run of its map's scenario.
struct StabilityCell {
  std::vector<std::string> values;  ///< one per axis of the map
  /// What differs from the scenario: the axes' places first, then what leads the tool. All cells of a map and
  /// pipeline have the same paths, in the same order.
  std::vector<Override> overrides;
  std::string refused = {};   ///< why `fissure run` refuses it (too many substeps, say); empty: it does not
  std::size_t rest_from = 0;  ///< first row of the record from which on the tool is led no more
  double step_s = 0;
  double thickness_m = 0;  ///< shortest side of the tool's bounding box, in its frame
};

/// The cells of one map and pipeline.
class StabilityCells {
 public:
  /// `base`: the map's scenario. Throws InputError where the map's pipeline or a place that an axis
  /// multiplies is not in it.
  StabilityCells(const LoadedScenario& base, const std::filesystem::path& file, const StabilityMap& map,
                 const StabilityPress& press, const std::string& pipeline);

  /// The cell with these values. Throws InputError for a scenario that is not valid, and for one without
  /// exactly one tool or with a motion that is no script which begins with a move at a speed.
  StabilityCell cell(const std::vector<std::string>& values) const;

  /// Whether the scenario takes whole numbers only where the map's last axis is; never for listed values.
  bool lastAxisIsWhole() const;

 private:
  std::vector<Override> axisOverrides(const std::vector<std::string>& values) const;
  void addTimes(StabilityCell& cell) const;
  void leadTool(StabilityCell& cell) const;
  std::string refusalOf(const StabilityCell& cell) const;

  const LoadedScenario& base_;
  std::filesystem::path file_;
  const StabilityMap& map_;
  StabilityPress press_;
  std::string pipeline_;
};

/// A value of a scenario with all of its numbers multiplied: "[0.04, 0.002]" by 2 is "[0.08, 0.004]". Throws
/// InputError where it has none.
std::string multiplied(const YamlNode& value, double factor);

}  // namespace fissure
