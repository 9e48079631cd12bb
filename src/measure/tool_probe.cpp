#include "measure/tool_probe.h"

#include "measure/statistics.h"

namespace fissure {

ToolProbe::ToolProbe(const Scene& scene) {
  for (const SceneTool& tool : scene.tools) names_.push_back(tool.name);
}

void ToolProbe::declare(RecordLayout& layout) {
  layout.addAxis({"tool", names_});
  layout.addAxis(xyzAxis());
  layout.addAxis({"quat", {"x", "y", "z", "w"}});
  position_column_ = layout.add({.name = "tool_position",
                                 .units = "m",
                                 .long_name = "origin of the tool, scene frame",
                                 .axes = {"tool", "xyz"}});
  quaternion_column_ = layout.add({.name = "tool_quaternion",
                                   .units = "1",
                                   .long_name = "orientation of the tool, scene frame",
                                   .axes = {"tool", "quat"}});
}

void ToolProbe::sample(const State& state, RecordRow& row) {
  for (std::size_t t = 0; t < names_.size(); ++t) {
    const Pose& pose = state.tools[t].pose;
    writeVector(pose.position_m, position_column_ + 3 * t, row);
    writeVector(pose.orientation.vec(), quaternion_column_ + 4 * t, row);
    row[quaternion_column_ + 4 * t + 3] = pose.orientation.w();
  }
}

void ToolProbe::summarize(Summary&) const {}

}  // namespace fissure
