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

std::vector<std::string> frameText(const std::string& run, double time_s, std::optional<double> depth_m) {
  std::vector<std::string> lines = {run, format("t = %.3f s", time_s)};
  if (depth_m) lines.push_back(format("depth = %.2f mm", 1000 * *depth_m));
  return lines;
}

}  // namespace fissure
