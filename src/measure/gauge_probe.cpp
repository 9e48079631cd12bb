#include "measure/gauge_probe.h"

namespace fissure {

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

}  // namespace fissure
