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
  check.require(!tool.coupling || !tool.clamp, "coupling",
                "is given for a clamp, expected a tool that does not open");
  if (tool.clamp) checkClamp(check.in("clamp"), tool);
  checkMotion(check.in("motion"), tool.motion, tool.clamp);
}

}  // namespace fissure
