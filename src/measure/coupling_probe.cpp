#include "measure/coupling_probe.h"

namespace fissure {

CouplingProbe::CouplingProbe(const Scenario& scenario) {
  for (const ToolSettings& tool : scenario.tools)
    if (tool.coupling) coupled_.push_back({.name = tool.name});
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
  }
}

void CouplingProbe::summarize(Summary& summary) const {
  for (const Coupled& seen : coupled_) {
    summary.push_back({seen.name + "_max_coupling_force_N", seen.force_N.value()});
    summary.push_back({seen.name + "_max_lag_m", seen.lag_m.value()});
    summary.push_back({seen.name + "_final_lag_m", seen.final_lag_m});
  }
}

}  // namespace fissure
