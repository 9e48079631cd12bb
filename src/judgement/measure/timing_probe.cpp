#include <cmath>

#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// Series timing/step_time_us and timing/collision_time_us, and their statistics. Rows without a time (the
/// initial state) are left out of these. The real-time factor is simulated over mean wall time of a step:
/// above 1 is faster than real time. Percentiles are of all steps up to most_kept, in longer runs of evenly
/// spaced ones, so that memory does not grow with the run.
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
  static constexpr std::size_t most_kept = 131072;  // even
  std::vector<double> step_us_;                     ///< of one step in stride_
  std::size_t stride_ = 1;
  std::size_t count_ = 0;
  double longest_us_ = kMissing;
  double step_sum_us_ = 0;
  double collision_sum_us_ = 0;
};

}  // namespace

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
  if (count_++ % stride_ == 0) step_us_.push_back(state.timing.step_us);
  if (step_us_.size() == most_kept) {
    for (std::size_t i = 0; i < most_kept / 2; ++i) step_us_[i] = step_us_[2 * i];
    step_us_.resize(most_kept / 2);
    stride_ *= 2;
  }
  longest_us_ = std::fmax(longest_us_, state.timing.step_us);
  step_sum_us_ += state.timing.step_us;
  collision_sum_us_ += state.timing.collision_us;
}

void TimingProbe::summarize(Summary& summary) const {
  const double count = static_cast<double>(count_);
  // 0 / 0 is NaN: no step, no statistics.
  const double mean_us = step_sum_us_ / count;
  summary.push_back({"timing/mean_step_us", mean_us});
  summary.push_back({"timing/p50_step_us", percentile(step_us_, 50)});
  summary.push_back({"timing/p99_step_us", percentile(step_us_, 99)});
  summary.push_back({"timing/max_step_us", longest_us_});
  summary.push_back({"timing/mean_collision_us", collision_sum_us_ / count});
  summary.push_back({"timing/collision_share", collision_sum_us_ / step_sum_us_});
  summary.push_back({"timing/real_time_factor", step_s_ * 1e6 / mean_us});
}

std::unique_ptr<Probe> makeTimingProbe(double step_s) {
  return std::make_unique<TimingProbe>(step_s);
}

}  // namespace fissure
