#include "measure/force_probe.h"

namespace fissure {

ForceProbe::ForceProbe(const std::vector<ForceSettings>& laws) {
  for (const ForceSettings& law : laws) laws_.push_back({law.name, {}, {}});
}

void ForceProbe::declare(RecordLayout& layout) {
  RecordAxis law_axis{"law", {}};
  for (const Law& law : laws_) law_axis.labels.push_back(law.name);
  layout.addAxis(law_axis);
  layout.addAxis(xyzAxis());
  force_column_ = layout.add({.name = "force",
                              .units = "N",
                              .long_name = "force on the tools, scene frame",
                              .axes = {"law", "xyz"}});
  elastic_column_ = layout.add({.name = "force_elastic",
                                .units = "N",
                                .long_name = "sum of the elastic terms of all triangles",
                                .axes = {"law"}});
  viscous_column_ = layout.add({.name = "force_viscous",
                                .units = "N",
                                .long_name = "sum of the viscous terms of all triangles, signed",
                                .axes = {"law"}});
  clamped_column_ = layout.add({.name = "adhesion_clamped",
                                .units = "1",
                                .long_name = "triangles that would have pulled and were set to 0",
                                .type = ValueType::count,
                                .axes = {"law"}});
}

void ForceProbe::sample(const State& state, RecordRow& row) {
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const ForceSample& force = state.forces[i];
    writeVector(force.force_on_tool_N, force_column_ + 3 * i, row);
    row[elastic_column_ + i] = force.elastic_N;
    row[viscous_column_ + i] = force.viscous_N;
    row[clamped_column_ + i] = force.adhesion_clamped;
    const double magnitude_N = force.force_on_tool_N.norm();
    laws_[i].max_N.add(magnitude_N);
    laws_[i].roughness.add(magnitude_N);
  }
}

void ForceProbe::summarize(Summary& summary) const {
  summary.push_back({"max_force_N", laws_.front().max_N.value()});
  summary.push_back({"force_roughness", laws_.front().roughness.value()});
  for (const Law& law : laws_) {
    summary.push_back({"max_force_" + law.name + "_N", law.max_N.value()});
    summary.push_back({"force_roughness_" + law.name, law.roughness.value()});
  }
}

}  // namespace fissure
