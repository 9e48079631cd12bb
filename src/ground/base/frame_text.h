#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// What a picture says of its step; no value where it is not measured.
struct FrameMeasures {
  std::optional<double> depth_m;            ///< penetration depth, metres
  std::optional<double> inversion_aware_m;  ///< the same with inverted tissue
  std::optional<double> ground_m;           ///< of tissue below the ground
  std::optional<double> certified;          ///< 0: the step's end is not proved free of overlap
  std::optional<double> pressure_Pa;        ///< the largest on an elastic body
};

/// The lines of text in a picture of a run: its name, the simulated time and the penetration depth; where
/// they are 0.01 mm or more, also what inverted tissue adds to it, and how deep tissue stands in the ground;
/// whether overlap is not excluded where the depth does not show it; and the
/// pressure that the tissue's darkest colour stands for, where it is pressed.
std::vector<std::string> frameText(const std::string& run, double time_s, const FrameMeasures& measures);

}  // namespace fissure
