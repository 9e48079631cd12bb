#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "measure/probe_makers.h"
#include "measure/same_triangles_roughness.h"
#include "measure/statistics.h"
#include "scenario/rigid_tools.h"
#include "scenario/tissues.h"

namespace fissure {

namespace {

/// Series force(law, xyz) on the tools, its terms force_elastic(law), force_viscous(law),
/// adhesion_clamped(law) and, of the triangles in a colliding state (colliding_triangles), largest and mean
/// deformation(law) and its rate(law); tool_force(law, tool, xyz); where a tool has a force limit
/// saturated(law, tool), the force itself stays as it is. Scalars: the largest magnitude, the roughness, that
/// of the triangles that stay (roughness_same_triangles), that of several tools' forces taken together
/// (tool_force_roughness) and, with a limit, the steps in which a tool was saturated, of every law; those of
/// the first law under their short names too.
/// force_non_finite_at_step_<law>, the first such step, only where a law's force overflowed;
/// laws_of_whole_probes only where a law has such coefficients (isOfWholeProbe).
class ForceProbe : public Probe {
 public:
  /// Laws and limits from `scenario`, which has at least one law; State::forces is in their order.
  ForceProbe(const Scenario& scenario, const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  struct Law {
    std::string name;
    RunningMax max_N;
    Roughness roughness;
    std::vector<Roughness> tool_roughness;  ///< one per tool; empty for a single tool or none
    long long saturated_steps = 0;
    std::optional<long long> non_finite_at_step;
  };
  void declareTools(RecordLayout& layout);
  void sampleTools(const State& state, std::size_t law, RecordRow& row);

  std::vector<Law> laws_;
  std::string of_whole_probes_;  ///< "hunt_crossley (pig_liver_1), ..."
  SameTrianglesRoughness same_triangles_;
  std::vector<std::string> tools_;
  std::vector<std::optional<double>> limits_N_;  ///< one per tool; empty where no tool has a limit
  bool sampled_ = false;
  std::size_t force_column_ = 0;
  std::size_t terms_column_ = 0;  ///< of the series with one value a law, in the order of declare()
  std::size_t triangles_column_ = 0;
  std::size_t tool_force_column_ = 0;
  std::size_t saturated_column_ = 0;
};

}  // namespace

namespace {

/// A series with one value a law, and where the value comes from.
struct Term {
  const char* name = "";
  const char* units = "";
  const char* long_name = "";
  double (*of)(const ForceSample&) = nullptr;
  ValueType type = ValueType::real;
};

constexpr std::array<Term, 8> terms = {{
    {"force_elastic", "N", "sum of the elastic terms of all triangles",
     [](const ForceSample& f) { return f.elastic_N; }},
    {"force_viscous", "N", "sum of the viscous terms of all triangles, signed",
     [](const ForceSample& f) { return f.viscous_N; }},
    {"adhesion_clamped", "1", "triangles that would have pulled and were set to 0",
     [](const ForceSample& f) { return static_cast<double>(f.adhesion_clamped); }, ValueType::count},
    {"deformation_max", "m", "largest deformation of a colliding triangle, 0 without one",
     [](const ForceSample& f) { return f.deformation_max_m; }},
    {"deformation_mean", "m", "mean deformation of the colliding triangles, 0 without one",
     [](const ForceSample& f) { return f.deformation_mean_m; }},
    {"deformation_rate_max", "m s-1", "fastest growth of a colliding triangle's deformation, 0 without one",
     [](const ForceSample& f) { return f.rate_max_m_s; }},
    {"deformation_rate_min", "m s-1", "the least of these rates, negative: deformation recedes",
     [](const ForceSample& f) { return f.rate_min_m_s; }},
    {"deformation_rate_mean", "m s-1", "mean rate of the colliding triangles' deformation, 0 without one",
     [](const ForceSample& f) { return f.rate_mean_m_s; }},
}};

}  // namespace

ForceProbe::ForceProbe(const Scenario& scenario, const Scene& scene)
    : same_triangles_(scenario.force.size()) {
  for (const ForceSettings& law : scenario.force) {
    laws_.push_back({.name = law.name});
    if (!isOfWholeProbe(law)) continue;
    of_whole_probes_ += fmt::format("{}{} ({})", of_whole_probes_.empty() ? "" : ", ", law.name, *law.tissue);
  }
  for (const SceneTool& tool : scene.tools) tools_.push_back(tool.name);
  if (tools_.size() > 1)
    for (Law& law : laws_) law.tool_roughness.resize(tools_.size());
  limits_N_.resize(tools_.size());
  for (const ToolSettings& tool : rigidTools(scenario.tools)) {
    const auto at = std::find(tools_.begin(), tools_.end(), tool.name);
    if (tool.coupling) continue;  // a hand feels the coupling (CouplingProbe), not the law
    if (at != tools_.end()) limits_N_[static_cast<std::size_t>(at - tools_.begin())] = tool.force_limit_N;
  }
  if (std::none_of(limits_N_.begin(), limits_N_.end(), [](const auto& limit) { return limit.has_value(); }))
    limits_N_.clear();
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
  terms_column_ = layout.columns();
  for (const Term& term : terms)
    layout.add({.name = term.name,
                .units = term.units,
                .long_name = term.long_name,
                .type = term.type,
                .axes = {"law"}});
  triangles_column_ = layout.add({.name = "colliding_triangles",
                                  .units = "1",
                                  .long_name = "tissue triangles with a vertex in a colliding state",
                                  .type = ValueType::count,
                                  .axes = {}});
  if (!tools_.empty()) declareTools(layout);
}

void ForceProbe::declareTools(RecordLayout& layout) {
  layout.addAxis({"tool", tools_});
  tool_force_column_ = layout.add({.name = "tool_force",
                                   .units = "N",
                                   .long_name = "force on each tool, scene frame",
                                   .axes = {"law", "tool", "xyz"}});
  if (limits_N_.empty()) return;
  saturated_column_ = layout.add({.name = "saturated",
                                  .units = "1",
                                  .long_name = "the force on the tool is beyond its device's limit",
                                  .type = ValueType::flag,
                                  .axes = {"law", "tool"}});
}

void ForceProbe::sample(const State& state, RecordRow& row) {
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const ForceSample& force = state.forces[i];
    writeVector(force.force_on_tool_N, force_column_ + 3 * i, row);
    for (std::size_t t = 0; t < terms.size(); ++t)
      row[terms_column_ + t * laws_.size() + i] = terms[t].of(force);
    const double magnitude_N = force.force_on_tool_N.norm();
    laws_[i].max_N.add(magnitude_N);
    laws_[i].roughness.add(magnitude_N);
    const bool finite = std::isfinite(magnitude_N + force.elastic_N + force.viscous_N);
    if (!finite && !laws_[i].non_finite_at_step) laws_[i].non_finite_at_step = state.step;
    if (!tools_.empty()) sampleTools(state, i, row);
  }
  same_triangles_.add(state);
  row[triangles_column_] = static_cast<double>(state.colliding_triangles.size());
  sampled_ = true;
}

void ForceProbe::sampleTools(const State& state, std::size_t law, RecordRow& row) {
  bool any = false;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const std::size_t at = law * tools_.size() + t;
    const Vec3& force_N = state.tool_forces_N[at];
    writeVector(force_N, tool_force_column_ + 3 * at, row);
    if (!laws_[law].tool_roughness.empty()) laws_[law].tool_roughness[t].add(force_N.norm());
    if (limits_N_.empty()) continue;
    // Negated, so that a force that is not a number counts as beyond the limit.
    const bool saturated = limits_N_[t] && !(force_N.norm() <= *limits_N_[t]);
    row[saturated_column_ + at] = saturated ? 1 : 0;
    any |= saturated;
  }
  if (any) ++laws_[law].saturated_steps;
}

void ForceProbe::summarize(Summary& summary) const {
  const auto add = [&](std::size_t index, const std::string& name) {
    const Law& law = laws_[index];
    summary.push_back({"max_force" + name + "_N", law.max_N.value(), true});
    summary.push_back({"force_roughness" + name, law.roughness.value(), true});
    summary.push_back({"roughness_same_triangles" + name, same_triangles_.value(index), true});
    if (!law.tool_roughness.empty())
      summary.push_back({"tool_force_roughness" + name, Roughness::of(law.tool_roughness), true});
    if (limits_N_.empty()) return;
    summary.push_back(countOrMissing("saturated_steps" + name, sampled_, law.saturated_steps));
    summary.back().of_law = true;
  };
  add(0, "");
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const Law& law = laws_[i];
    add(i, "_" + law.name);
    if (law.non_finite_at_step)
      summary.push_back({"force_non_finite_at_step_" + law.name, *law.non_finite_at_step, true});
  }
  if (!of_whole_probes_.empty()) summary.push_back({"laws_of_whole_probes", of_whole_probes_, true});
}

std::unique_ptr<Probe> makeForceProbe(const Scenario& scenario, const Scene& scene) {
  return std::make_unique<ForceProbe>(scenario, scene);
}

}  // namespace fissure
