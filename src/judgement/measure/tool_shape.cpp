#include "measure/tool_shape.h"

#include <algorithm>

#include "surface/distance.h"
#include "surface/winding.h"

namespace fissure {

ToolShape::ToolShape(const SceneTool& tool) : closed_(tool.closed) {
  if (tool.box_size_m)
    half_size_m_ = *tool.box_size_m / 2;
  else
    surface_.emplace(tool.surface);
}

double ToolShape::signedDistance_m(const Vec3& in_tool, double limit_m) const {
  if (half_size_m_) {
    const Vec3 beyond = in_tool.cwiseAbs() - *half_size_m_;
    const double deepest = beyond.maxCoeff();
    return deepest <= 0 ? deepest : beyond.cwiseMax(0.0).norm();
  }
  const Vec3 point = SurfaceTree::toTree(in_tool);
  if (closed_ && windingNumber(*surface_, point) > 0) return -distance_m(*surface_, point);
  return distance_m(*surface_, point, {.limit_m = limit_m});
}

}  // namespace fissure
