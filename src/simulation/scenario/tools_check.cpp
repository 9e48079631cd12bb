#include "scenario/checker.h"

namespace fissure {

void checkTool(Checker check, const ToolSettings& tool) {
  checkShape(check.in("shape"), tool.shape);
  Checker nodes = check.in("nodes");
  const bool left_box =
      !tool.clamp || !tool.clamp->left_jaw || std::holds_alternative<BoxShape>(tool.clamp->left_jaw->shape);
  nodes.require(tool.nodePlacement() != NodePlacement::grid ||
                    (std::holds_alternative<BoxShape>(tool.shape) && left_box),
                "placement", "is grid, expected centroids: only a box has large faces for a grid");
  for (const int count : tool.nodes.resolution) nodes.between("resolution", count, 1, 512);
  nodes.between("narrow_rows", tool.nodes.narrow_rows, 0, 512);
  if (tool.nodes.max_spacing_m) nodes.positive("max_spacing_m", *tool.nodes.max_spacing_m);
  nodes.positive("pairing_limit", tool.nodes.pairing_limit);
  check.notNegative("friction", tool.friction);
  if (tool.force_limit_N) check.positive("force_limit_N", *tool.force_limit_N);
  if (tool.coupling) {
    Checker coupling = check.in("coupling");
    coupling.positive("mass_kg", tool.coupling->mass_kg);
    coupling.positive("stiffness_N_m", tool.coupling->stiffness_N_m);
    coupling.notNegative("damping_N_s_m", tool.coupling->damping_N_s_m);
    coupling.require(!tool.clamp, "", "is given for a clamp, expected a tool that does not open");
  }
  if (tool.clamp) checkClamp(check.in("clamp"), tool);
  checkMotion(check.in("motion"), tool.motion, tool.clamp);
}

}  // namespace fissure
