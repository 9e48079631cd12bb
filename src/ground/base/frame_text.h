#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// The measured values of one step that are printed into its picture; no value: not measured.
struct FrameMeasures {
  std::optional<double> depth_m;  ///< penetration depth, metres
  /// Inversion-aware penetration depth (measure/METHOD.md 2), metres.
  std::optional<double> inversion_aware_m;
  std::optional<double> ground_m;     ///< depth of the lowest tissue vertex below the ground, metres
  std::optional<double> certified;    ///< 0: the step's end is not proved free of overlap
  std::optional<double> pressure_Pa;  ///< largest contact pressure on an elastic body, pascals
};

/// The lines of text in a picture of a run: the run's name, the simulated time and the penetration depth.
/// Further lines follow where they apply: the inversion-aware depth where it is at least 0.01 mm larger, the
/// depth of tissue below the ground from 0.01 mm on, a note where overlap is not excluded although the depth
/// is below 0.01 mm, and the pressure for which the tissue's darkest colour stands.
std::vector<std::string> frameText(const std::string& run, double time_s, const FrameMeasures& measures);

}  // namespace fissure
