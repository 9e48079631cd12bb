#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// The lines of text in a picture of a run: its name, the simulated time and the penetration depth, where
/// that is measured.
std::vector<std::string> frameText(const std::string& run, double time_s, std::optional<double> depth_m);

}  // namespace fissure
