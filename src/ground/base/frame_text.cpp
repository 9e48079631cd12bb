#include "base/frame_text.h"

#include <fmt/core.h>

namespace fissure {

std::vector<std::string> frameText(const std::string& run, double time_s, const FrameMeasures& measures) {
  std::vector<std::string> lines = {run, fmt::format("t = {:.3f} s", time_s)};
  constexpr double shown_m = 1e-5;
  if (measures.depth_m) lines.push_back(fmt::format("depth = {:.2f} mm", 1000 * *measures.depth_m));
  if (measures.inversion_aware_m.value_or(0) - measures.depth_m.value_or(0) >= shown_m)
    lines.push_back(fmt::format("with inversion {:.2f} mm", 1000 * *measures.inversion_aware_m));
  if (measures.ground_m.value_or(0) >= shown_m)
    lines.push_back(fmt::format("tissue {:.2f} mm below ground", 1000 * *measures.ground_m));
  if (measures.certified.value_or(1) == 0 && measures.depth_m.value_or(0) < shown_m)
    lines.emplace_back("overlap not excluded");
  if (measures.pressure_Pa.value_or(0) > 0)
    lines.push_back(fmt::format("pressure up to {:.3g} kPa", *measures.pressure_Pa / 1000));
  return lines;
}

}  // namespace fissure
