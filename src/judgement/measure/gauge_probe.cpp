#include <array>
#include <optional>
#include <vector>

#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

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
  std::vector<Range> ranges_;  ///< one per gauge
  std::size_t column_ = 0;
};

}  // namespace

namespace {

Vec3 meanPlace_m(const Gauge& gauge, const State& state) {
  Vec3 sum = Vec3::Zero();
  for (const int vertex : gauge.vertices) sum += state.positions_m[vertex];
  return sum / static_cast<double>(gauge.vertices.size());
}

}  // namespace

GaugeProbe::GaugeProbe(const Scene& scene) {
  for (const SceneBody& body : scene.bodies) {
    for (Gauge gauge : body.gauges) {
      for (int& vertex : gauge.vertices) vertex += body.first_vertex;
      gauges_.push_back(std::move(gauge));
    }
  }
  ranges_.resize(gauges_.size());
}

void GaugeProbe::declare(RecordLayout& layout) {
  RecordAxis axis{"gauge", {}};
  for (const Gauge& gauge : gauges_) axis.labels.push_back(gauge.name);
  layout.addAxis(axis);
  layout.addAxis(xyzAxis());
  column_ = layout.add({.name = "gauge_displacement",
                        .units = "m",
                        .long_name = "mean way of a gauge's vertices since time zero, scene frame",
                        .axes = {"gauge", "xyz"}});
}

void GaugeProbe::sample(const State& state, RecordRow& row) {
  for (std::size_t i = 0; i < gauges_.size(); ++i) {
    const Vec3 place_m = meanPlace_m(gauges_[i], state);
    Range& range = ranges_[i];
    if (!range.start_m) range.start_m = place_m;
    range.final_m = place_m - *range.start_m;
    for (int axis = 0; axis < 3; ++axis) {
      range.back_m[axis].add(-range.final_m[axis]);
      range.forth_m[axis].add(range.final_m[axis]);
    }
    writeVector(range.final_m, column_ + 3 * i, row);
  }
}

void GaugeProbe::summarize(Summary& summary) const {
  for (std::size_t i = 0; i < gauges_.size(); ++i) {
    const Range& range = ranges_[i];
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name = "gauge_" + gauges_[i].name + "_" + "xyz"[axis];
      summary.push_back({name + "_min_m", 0.0 - range.back_m[axis].value()});
      summary.push_back({name + "_max_m", range.forth_m[axis].value()});
      summary.push_back({name + "_final_m", range.final_m[axis]});
    }
  }
}

std::unique_ptr<Probe> makeGaugeProbe(const Scene& scene) {
  return std::make_unique<GaugeProbe>(scene);
}

}  // namespace fissure
