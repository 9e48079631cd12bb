#include <cmath>

#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// Series ground_depth, how deep the lowest tissue vertex stands below the ground's plane, and its largest
/// value as the scalar max_ground_depth_m. An engine's ground gives way under load, and what a tool does not
/// push in there it does not push in anywhere else.
class GroundProbe : public Probe {
 public:
  explicit GroundProbe(double height_m) : height_m_(height_m) {}

  void declare(RecordLayout& layout) override {
    column_ = layout.add({.name = "ground_depth",
                          .units = "m",
                          .long_name = "deepest tissue vertex below the ground, 0 when none is",
                          .axes = {}});
  }
  void sample(const State& state, RecordRow& row) override {
    double depth_m = 0;
    for (const Vec3& position_m : state.positions_m) {
      const double below_m = height_m_ - position_m.y();
      if (below_m > depth_m || std::isnan(below_m)) depth_m = below_m;
      if (std::isnan(depth_m)) break;
    }
    max_m_.add(depth_m);
    row[column_] = depth_m;
  }
  void summarize(Summary& summary) const override {
    summary.push_back({"max_ground_depth_m", max_m_.value()});
  }

 private:
  double height_m_ = 0;
  RunningMax max_m_;
  std::size_t column_ = 0;
};

}  // namespace

std::unique_ptr<Probe> makeGroundProbe(double height_m) {
  return std::make_unique<GroundProbe>(height_m);
}

}  // namespace fissure
