#include "measure/tool_shape.h"

#include <algorithm>

#include "base/error.h"
#include "measure/distance.h"
#include "measure/winding.h"
#include "mesh/check.h"

namespace fissure {

ToolShape::ToolShape(const SceneTool& tool) {
  if (tool.box_size_m) {
    half_size_m_ = *tool.box_size_m / 2;
    return;
  }
  const std::vector<std::string> defects = findDefects(tool.surface);
  if (!defects.empty()) {
    throw InputError("tool '" + tool.name + "': " + defects.front() +
                     ", expected a closed surface: penetration cannot be measured without an inside");
  }
  surface_.emplace(tool.surface);
}

double ToolShape::signedDistance_m(const Vec3& in_tool, double limit_m) const {
  if (half_size_m_) {
    const Vec3 beyond = in_tool.cwiseAbs() - *half_size_m_;
    const double deepest = beyond.maxCoeff();
    return deepest <= 0 ? deepest : beyond.cwiseMax(0.0).norm();
  }
  const Vec3 point = SurfaceTree::toTree(in_tool);
  if (windingNumber(*surface_, point) > 0) return -distance_m(*surface_, point);
  return distance_m(*surface_, point, {.limit_m = limit_m});
}

}  // namespace fissure
