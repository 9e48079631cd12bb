#pragma once

#include "base/probe.h"
#include "measure/statistics.h"

namespace fissure {

/// Series timing/step_time_us and timing/collision_time_us, and their statistics. Rows without a time (the
/// initial state) are left out of these. The real-time factor is simulated over mean wall time of a step:
/// above 1 is faster than real time.
class TimingProbe : public Probe {
 public:
  explicit TimingProbe(double step_s) : step_s_(step_s) {}

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  double step_s_ = 0;
  std::size_t step_column_ = 0;
  std::size_t collision_column_ = 0;
  std::vector<double> step_us_;
  double step_sum_us_ = 0;
  double collision_sum_us_ = 0;
};

}  // namespace fissure
