#include "base/frame_text.h"

#include <array>
#include <cstdio>

namespace fissure {

namespace {

std::string format(const char* pattern, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), pattern, value);
  return text.data();
}

}  // namespace

std::vector<std::string> frameText(const std::string& run, double time_s, const FrameMeasures& depths) {
  std::vector<std::string> lines = {run, format("t = %.3f s", time_s)};
  constexpr double shown_m = 1e-5;
  if (depths.depth_m) lines.push_back(format("depth = %.2f mm", 1000 * *depths.depth_m));
  if (depths.inversion_aware_m.value_or(0) - depths.depth_m.value_or(0) >= shown_m)
    lines.push_back(format("with inversion %.2f mm", 1000 * *depths.inversion_aware_m));
  if (depths.ground_m.value_or(0) >= shown_m)
    lines.push_back(format("tissue %.2f mm below ground", 1000 * *depths.ground_m));
  if (depths.certified.value_or(1) == 0 && depths.depth_m.value_or(0) < shown_m)
    lines.emplace_back("overlap not excluded");
  return lines;
}

}  // namespace fissure
