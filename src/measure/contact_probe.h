#pragma once

#include "base/probe.h"
#include "base/scene.h"
#include "measure/statistics.h"

namespace fissure {

/// Series contact_count and reaction_force(xyz), of several tools also tool_reaction(tool, xyz); where the
/// pipeline has tool nodes also candidate_count, infeasible_count and capped_count, and the scalar
/// node_switch_rate_hz.
class ContactProbe : public Probe {
 public:
  explicit ContactProbe(const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  void countSwitches(const State& state);
  double switchRate_hz() const;

  std::size_t node_count_ = 0;
  std::vector<std::string> tools_;  ///< empty: one at most
  std::size_t contact_column_ = 0;
  std::size_t candidate_column_ = 0;
  std::size_t infeasible_column_ = 0;
  std::size_t capped_column_ = 0;
  std::size_t reaction_column_ = 0;
  std::size_t tool_reaction_column_ = 0;

  long long steps_ = 0;
  long long contacts_total_ = 0;
  long long max_contacts_ = 0;
  long long switches_ = 0;
  double first_time_s_ = 0;
  double last_time_s_ = 0;
  double first_contact_time_s_ = kMissing;
  std::vector<std::uint8_t> acting_;  // of each node in the last step
};

}  // namespace fissure
