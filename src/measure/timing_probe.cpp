#include "measure/timing_probe.h"

#include <cmath>

namespace fissure {

void TimingProbe::declare(RecordLayout& layout) {
  step_column_ = layout.add({.name = "timing/step_time_us",
                             .units = "us",
                             .long_name = "wall time of the step, without measuring and writing",
                             .axes = {}});
  collision_column_ = layout.add({.name = "timing/collision_time_us",
                                  .units = "us",
                                  .long_name = "wall time of the step's collision part, tool against tissue",
                                  .axes = {}});
}

void TimingProbe::sample(const State& state, RecordRow& row) {
  row[step_column_] = state.timing.step_us;
  row[collision_column_] = state.timing.collision_us;
  if (std::isnan(state.timing.step_us)) return;
  step_us_.push_back(state.timing.step_us);
  step_sum_us_ += state.timing.step_us;
  collision_sum_us_ += state.timing.collision_us;
}

void TimingProbe::summarize(Summary& summary) const {
  const double count = static_cast<double>(step_us_.size());
  // 0 / 0 is NaN: no step, no statistics.
  const double mean_us = step_sum_us_ / count;
  summary.push_back({"timing/mean_step_us", mean_us});
  summary.push_back({"timing/p50_step_us", percentile(step_us_, 50)});
  summary.push_back({"timing/p99_step_us", percentile(step_us_, 99)});
  summary.push_back({"timing/max_step_us", percentile(step_us_, 100)});
  summary.push_back({"timing/mean_collision_us", collision_sum_us_ / count});
  summary.push_back({"timing/collision_share", collision_sum_us_ / step_sum_us_});
  summary.push_back({"timing/real_time_factor", step_s_ * 1e6 / mean_us});
}

}  // namespace fissure
