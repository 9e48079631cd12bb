#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

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

}  // namespace

CouplingProbe::CouplingProbe(const Scenario& scenario) {
  for (const ToolSettings& tool : scenario.tools)
    if (tool.coupling) coupled_.push_back({.name = tool.name, .limit_N = tool.force_limit_N});
}

void CouplingProbe::declare(RecordLayout& layout) {
  RecordAxis axis{"coupling", {}};
  for (const Coupled& coupled : coupled_) axis.labels.push_back(coupled.name);
  layout.addAxis(axis);
  layout.addAxis(xyzAxis());
  target_column_ = layout.add({.name = "coupling_target",
                               .units = "m",
                               .long_name = "where the motion wants the origin of the tool, scene frame",
                               .axes = {"coupling", "xyz"}});
  force_column_ = layout.add({.name = "coupling_force",
                              .units = "N",
                              .long_name = "force of spring and damper on the tool, scene frame",
                              .axes = {"coupling", "xyz"}});
  if (std::none_of(coupled_.begin(), coupled_.end(), [](const Coupled& c) { return c.limit_N.has_value(); }))
    return;
  saturated_column_ = layout.add({.name = "coupling_saturated",
                                  .units = "1",
                                  .long_name = "the coupling's force is beyond the device's limit",
                                  .type = ValueType::flag,
                                  .axes = {"coupling"}});
}

void CouplingProbe::sample(const State& state, RecordRow& row) {
  for (std::size_t i = 0; i < coupled_.size(); ++i) {
    const CouplingState& coupling = state.couplings[i];
    writeVector(coupling.target_m, target_column_ + 3 * i, row);
    writeVector(coupling.force_on_tool_N, force_column_ + 3 * i, row);
    Coupled& seen = coupled_[i];
    seen.final_lag_m = (coupling.target_m - state.tools[coupling.tool].pose.position_m).norm();
    seen.force_N.add(coupling.force_on_tool_N.norm());
    seen.lag_m.add(seen.final_lag_m);
    if (!saturated_column_) continue;
    // Negated, so that a force that is not a number counts as beyond the limit.
    const bool saturated = seen.limit_N && !(coupling.force_on_tool_N.norm() <= *seen.limit_N);
    row[*saturated_column_ + i] = saturated ? 1 : 0;
    seen.saturated_steps += saturated ? 1 : 0;
  }
}

void CouplingProbe::summarize(Summary& summary) const {
  for (const Coupled& seen : coupled_) {
    summary.push_back({seen.name + "_max_coupling_force_N", seen.force_N.value()});
    summary.push_back({seen.name + "_max_lag_m", seen.lag_m.value()});
    summary.push_back({seen.name + "_final_lag_m", seen.final_lag_m});
    if (seen.limit_N) summary.push_back({seen.name + "_coupling_saturated_steps", seen.saturated_steps});
  }
}

std::unique_ptr<Probe> makeCouplingProbe(const Scenario& scenario) {
  return std::make_unique<CouplingProbe>(scenario);
}

}  // namespace fissure
