#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

#include "allocations.h"

namespace fissure::bench {

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The timed calls of one batch.
class Batch {
 public:
  template <class Work>
  void time(Work&& work) {
    using Clock = std::chrono::steady_clock;
    const long long before = allocations();
    const auto start = Clock::now();
    work();
    const auto end = Clock::now();
    allocations_ += allocations() - before;
    seconds_.push_back(std::chrono::duration<double>(end - start).count());
  }

  /// Of a call.
  double median_s() const { return median(seconds_); }
  double mean_s() const {
    double sum_s = 0;
    for (const double call_s : seconds_) sum_s += call_s;
    return sum_s / static_cast<double>(seconds_.size());
  }
  /// Of all calls.
  double allocationCount() const { return static_cast<double>(allocations_); }
  double size() const { return static_cast<double>(seconds_.size()); }

 private:
  std::vector<double> seconds_;
  long long allocations_ = 0;
};

}  // namespace fissure::bench
