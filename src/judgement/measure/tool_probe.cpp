#include "base/motion_peaks.h"
#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// Series tool_position(tool, xyz) and tool_quaternion(tool, quat): where the tools are at the end of a step.
/// Scalars, each with the tool's name before it: max_speed_m_s and max_acceleration_m_s2, of its origin, by
/// differences over the steps.
class ToolProbe : public Probe {
 public:
  ToolProbe(const Scene& scene, double step_s);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  std::vector<std::string> names_;
  std::vector<MotionPeaks> peaks_;  ///< one per tool
  std::size_t position_column_ = 0;
  std::size_t quaternion_column_ = 0;
};

}  // namespace

ToolProbe::ToolProbe(const Scene& scene, double step_s) : peaks_(scene.tools.size(), MotionPeaks(step_s)) {
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
    peaks_[t].add(pose.position_m);
    writeVector(pose.position_m, position_column_ + 3 * t, row);
    writeVector(pose.orientation.vec(), quaternion_column_ + 4 * t, row);
    row[quaternion_column_ + 4 * t + 3] = pose.orientation.w();
  }
}

void ToolProbe::summarize(Summary& summary) const {
  for (std::size_t t = 0; t < names_.size(); ++t) {
    summary.push_back({names_[t] + "_max_speed_m_s", peaks_[t].speed_m_s()});
    summary.push_back({names_[t] + "_max_acceleration_m_s2", peaks_[t].acceleration_m_s2()});
  }
}

std::unique_ptr<Probe> makeToolProbe(const Scene& scene, double step_s) {
  return std::make_unique<ToolProbe>(scene, step_s);
}

}  // namespace fissure
