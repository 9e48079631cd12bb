#pragma once

#include "base/probe.h"
#include "measure/penetration.h"
#include "measure/statistics.h"

namespace fissure {

/// Series penetration_depth, passed_through, inverted_triangles, stand_off; their worst and last values as
/// scalars.
class PenetrationProbe : public Probe {
 public:
  /// Throws InputError as PenetrationMeter does.
  PenetrationProbe(const Scene& scene, const MeasureSettings& settings);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  PenetrationMeter meter_;
  std::string not_measured_;  ///< one line; empty: all was
  Penetration last_;
  bool sampled_ = false;
  RunningMax max_depth_m_;
  long long max_inverted_ = 0;
  std::size_t depth_column_ = 0;
  std::size_t passed_column_ = 0;
  std::size_t inverted_column_ = 0;
  std::size_t stand_off_column_ = 0;
};

}  // namespace fissure
