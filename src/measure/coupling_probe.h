#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/probe.h"
#include "base/scene.h"
#include "measure/statistics.h"
#include "scenario/scenario.h"

namespace fissure {

/// What a hand feels of tools that hang on virtual couplings: series coupling_target(coupling, xyz), where
/// the motion wants the tool, and coupling_force(coupling, xyz), of spring and damper on it. Scalars, each
/// with the tool's name before it: max_coupling_force_N, max_lag_m and final_lag_m, the distance from its
/// target. Where a tool stands for a device with a force limit, the flag coupling_saturated(coupling) and the
/// count coupling_saturated_steps: what the device could not give.
class CouplingProbe : public Probe {
 public:
  /// Axis `coupling`: the tools with one.
  explicit CouplingProbe(const Scenario& scenario);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  struct Coupled {
    std::string name;
    RunningMax force_N = {}, lag_m = {};
    double final_lag_m = kMissing;
    std::optional<double> limit_N = {};
    long long saturated_steps = 0;
  };

  std::vector<Coupled> coupled_;
  std::size_t target_column_ = 0;
  std::size_t force_column_ = 0;
  std::optional<std::size_t> saturated_column_;  // none: no tool has a limit
};

}  // namespace fissure
