#include "scenario/rigid_tools.h"

namespace fissure {

std::array<std::string, 2> jawNames(const ToolSettings& clamp) {
  return {clamp.name + "_left", clamp.name + "_right"};
}

std::array<ClampPart, 2> closedJaws(const ToolSettings& clamp) {
  const ClampSettings& settings = *clamp.clamp;
  const Vec3& p = settings.jaw_position_m;
  const Quat& q = settings.jaw_orientation;
  const ClampPart mirrored{clamp.shape, Vec3(-p.x(), p.y(), p.z()), Quat(q.w(), q.x(), -q.y(), -q.z()), true};
  return {settings.left_jaw.value_or(mirrored), ClampPart{clamp.shape, p, q}};
}

std::vector<ToolSettings> rigidTools(const std::vector<ToolSettings>& tools) {
  std::vector<ToolSettings> rigid;
  for (const ToolSettings& tool : tools) {
    if (!tool.clamp) {
      rigid.push_back(tool);
      continue;
    }
    const std::array<ClampPart, 2> jaws = closedJaws(tool);
    const std::array<std::string, 2> names = jawNames(tool);
    for (std::size_t side = 0; side < 2; ++side) {
      ToolSettings jaw = tool;
      jaw.name = names[side];
      jaw.shape = jaws[side].shape;
      jaw.mirrored = jaws[side].mirrored;
      jaw.clamp.reset();
      jaw.motion = {};
      rigid.push_back(std::move(jaw));
    }
  }
  return rigid;
}

}  // namespace fissure
