#include <algorithm>
#include <cmath>

#include "measure/node_spacing.h"
#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// Series contact_count and reaction_force(xyz) with its roughness, of several tools also
/// tool_reaction(tool, xyz) and the roughness of these taken together; where the pipeline has tool nodes also
/// candidate_count, infeasible_count and capped_count, and the scalars node_switch_rate_hz, node_spacing_m
/// and node_spacing_over_edge (NodeSpacing). Where nodes stand on all sides of a tool also oblique_steps:
/// those with contact in which such a tool moves obliquely (isOblique).
class ContactProbe : public Probe {
 public:
  explicit ContactProbe(const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  void countSwitches(const State& state);
  void countOblique(const State& state);
  double switchRate_hz() const;

  std::size_t node_count_ = 0;
  std::optional<NodeSpacing> spacing_;
  std::vector<std::size_t> all_sided_;  ///< tools with nodes on all sides
  std::vector<std::string> tools_;      ///< empty: one at most
  std::size_t contact_column_ = 0;
  std::size_t candidate_column_ = 0;
  std::size_t infeasible_column_ = 0;
  std::size_t capped_column_ = 0;
  std::size_t reaction_column_ = 0;
  std::size_t tool_reaction_column_ = 0;

  long long steps_ = 0;
  long long oblique_steps_ = 0;
  RunningMax max_reaction_N_;
  Roughness roughness_;
  std::vector<Roughness> tool_roughness_;  ///< one per tool; empty for a single tool or none
  long long contacts_total_ = 0;
  long long max_contacts_ = 0;
  long long switches_ = 0;
  double first_time_s_ = 0;
  double last_time_s_ = 0;
  double first_contact_time_s_ = kMissing;
  std::vector<std::uint8_t> acting_;  // of each node in the last step
};

}  // namespace

ContactProbe::ContactProbe(const Scene& scene)
    : node_count_(static_cast<std::size_t>(scene.nodeCount())), spacing_(widestNodeSpacing(scene)) {
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    if (scene.tools[t].nodes.all_sides) all_sided_.push_back(t);
  if (scene.tools.size() < 2) return;
  for (const SceneTool& tool : scene.tools) tools_.push_back(tool.name);
  tool_roughness_.resize(tools_.size());
}

void ContactProbe::declare(RecordLayout& layout) {
  const auto count = [&](const char* name, const char* long_name) {
    return layout.add(
        {.name = name, .units = "1", .long_name = long_name, .type = ValueType::count, .axes = {}});
  };
  contact_column_ = count("contact_count", "contacts that act on the tissue");
  if (node_count_ > 0) {
    infeasible_column_ = count("infeasible_count", "candidate contacts excluded by their pair");
    candidate_column_ = count("candidate_count", "contacts proposed by the detector");
    capped_column_ = count("capped_count", "acting contacts whose displacement hit the limit of one step");
  }
  layout.addAxis(xyzAxis());
  reaction_column_ = layout.add({.name = "reaction_force",
                                 .units = "N",
                                 .long_name = "constraint reaction of the contacts on the tools, scene frame",
                                 .axes = {"xyz"}});
  if (tools_.empty()) return;
  layout.addAxis({"tool", tools_});
  tool_reaction_column_ = layout.add({.name = "tool_reaction",
                                      .units = "N",
                                      .long_name = "constraint reaction on each tool, scene frame",
                                      .axes = {"tool", "xyz"}});
}

void ContactProbe::sample(const State& state, RecordRow& row) {
  row[contact_column_] = state.contact.contact_count;
  if (node_count_ > 0) {
    row[infeasible_column_] = state.contact.infeasible_count;
    row[candidate_column_] = state.contact.candidate_count;
    row[capped_column_] = state.contact.capped_count;
    countSwitches(state);
  }
  if (!all_sided_.empty()) countOblique(state);
  writeVector(state.contact.reaction_on_tool_N, reaction_column_, row);
  max_reaction_N_.add(state.contact.reaction_on_tool_N.norm());
  roughness_.add(state.contact.reaction_on_tool_N.norm());
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const bool known = !state.contact.tool_reactions_N.empty();
    const Vec3 reaction_N = known ? state.contact.tool_reactions_N[t] : Vec3(Vec3::Constant(kMissing));
    writeVector(reaction_N, tool_reaction_column_ + 3 * t, row);
    tool_roughness_[t].add(reaction_N.norm());
  }

  if (steps_ == 0) first_time_s_ = state.time_s;
  last_time_s_ = state.time_s;
  ++steps_;
  contacts_total_ += state.contact.contact_count;
  max_contacts_ = std::max<long long>(max_contacts_, state.contact.contact_count);
  if (state.contact.contact_count > 0 && std::isnan(first_contact_time_s_))
    first_contact_time_s_ = state.time_s;
}

void ContactProbe::countSwitches(const State& state) {
  const bool first = acting_.empty();
  acting_.resize(node_count_, 0);
  for (std::size_t i = 0; i < node_count_; ++i) {
    const NodeState node = state.contact.node_states[i];
    const std::uint8_t acting = node == NodeState::feasible || node == NodeState::capped;
    if (!first && acting != acting_[i]) ++switches_;
    acting_[i] = acting;
  }
}

void ContactProbe::countOblique(const State& state) {
  if (state.contact.contact_count == 0) return;
  const bool any = std::any_of(all_sided_.begin(), all_sided_.end(), [&](std::size_t t) {
    return isOblique(state.tools[t].pose.rotateToBody(state.tools[t].velocity_m_s));
  });
  if (any) ++oblique_steps_;
}

double ContactProbe::switchRate_hz() const {
  const double duration_s = last_time_s_ - first_time_s_;
  if (!(duration_s > 0)) return kMissing;
  return static_cast<double>(switches_) / (static_cast<double>(node_count_) * duration_s);
}

void ContactProbe::summarize(Summary& summary) const {
  summary.push_back({"first_contact_time_s", first_contact_time_s_});
  summary.push_back(countOrMissing("max_contact_count", steps_ > 0, max_contacts_));
  summary.push_back(countOrMissing("contacts_total", steps_ > 0, contacts_total_));
  summary.push_back({"max_reaction_N", max_reaction_N_.value()});
  summary.push_back({"reaction_roughness", roughness_.value()});
  if (!tools_.empty()) summary.push_back({"tool_reaction_roughness", Roughness::of(tool_roughness_)});
  if (node_count_ > 0) summary.push_back({"node_switch_rate_hz", switchRate_hz()});
  if (spacing_) {
    summary.push_back({"node_spacing_m", spacing_->spacing_m});
    summary.push_back({"node_spacing_over_edge", spacing_->ratio()});
  }
  if (!all_sided_.empty()) summary.push_back(countOrMissing("oblique_steps", steps_ > 0, oblique_steps_));
}

std::unique_ptr<Probe> makeContactProbe(const Scene& scene) {
  return std::make_unique<ContactProbe>(scene);
}

}  // namespace fissure
