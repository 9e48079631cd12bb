#pragma once

#include "base/probe.h"
#include "measure/statistics.h"
#include "scenario/pipelines.h"

namespace fissure {

/// Series force(law, xyz) on the tools, its terms force_elastic(law), force_viscous(law), and
/// adhesion_clamped(law); the largest magnitude and the roughness of every law as scalars, those of the first
/// law under their short names too.
class ForceProbe : public Probe {
 public:
  /// `laws` in the order of State::forces; at least one.
  explicit ForceProbe(const std::vector<ForceSettings>& laws);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  struct Law {
    std::string name;
    RunningMax max_N;
    Roughness roughness;
  };
  std::vector<Law> laws_;
  std::size_t force_column_ = 0;
  std::size_t elastic_column_ = 0;
  std::size_t viscous_column_ = 0;
  std::size_t clamped_column_ = 0;
};

}  // namespace fissure
