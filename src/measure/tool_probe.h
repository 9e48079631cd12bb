#pragma once

#include "base/probe.h"
#include "base/scene.h"

namespace fissure {

/// Series tool_position(tool, xyz) and tool_quaternion(tool, quat): where the tools are at the end of a step.
class ToolProbe : public Probe {
 public:
  explicit ToolProbe(const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  std::vector<std::string> names_;
  std::size_t position_column_ = 0;
  std::size_t quaternion_column_ = 0;
};

}  // namespace fissure
