#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/probe.h"
#include "base/scene.h"
#include "measure/statistics.h"

namespace fissure {

/// Series gauge_displacement(gauge, xyz): the mean way of a gauge's vertices since time zero (after
/// settling), metres, scene frame. Scalars of each gauge and axis: gauge_<name>_<x, y or z>_min_m, _max_m and
/// _final_m.
class GaugeProbe : public Probe {
 public:
  explicit GaugeProbe(const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  struct Range {
    std::optional<Vec3> start_m;                ///< mean place at time zero
    std::array<RunningMax, 3> back_m, forth_m;  ///< largest ways against and along each axis
    Vec3 final_m = Vec3::Constant(kMissing);
  };

  std::vector<Gauge> gauges_;  ///< of all bodies; their vertices count over all bodies
  std::vector<Range> ranges_;  ///< one a gauge
  std::size_t column_ = 0;
};

}  // namespace fissure
