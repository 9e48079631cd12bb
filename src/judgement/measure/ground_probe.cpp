#include <cmath>

#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// Series ground_depth, how deep the lowest tissue vertex stands below the ground's plane, and its largest
/// value as the scalar max_ground_depth_m. An engine's ground gives way under load, and what a tool does not
/// push in there it does not push in anywhere else. Where states say it, also series ground_reaction, the
/// momentum that contacts with the ground took from the tissue in the step, over dt, and the largest as
/// max_ground_reaction_N.
class GroundProbe : public Probe {
 public:
  explicit GroundProbe(const Scene& scene)
      : height_m_(*scene.ground_height_m), with_reaction_(scene.ground_reaction_known) {}

  void declare(RecordLayout& layout) override {
    column_ = layout.add({.name = "ground_depth",
                          .units = "m",
                          .long_name = "deepest tissue vertex below the ground, 0 when none is",
                          .axes = {}});
    if (!with_reaction_) return;
    layout.addAxis(xyzAxis());
    reaction_column_ =
        layout.add({.name = "ground_reaction",
                    .units = "N",
                    .long_name = "constraint reaction of the tissue on the ground, scene frame",
                    .axes = {"xyz"}});
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
    if (!with_reaction_) return;
    const Vec3 reaction_N = state.contact.ground_reaction_N.value_or(Vec3::Zero());
    max_reaction_N_.add(reaction_N.norm());
    writeVector(reaction_N, reaction_column_, row);
  }
  void summarize(Summary& summary) const override {
    summary.push_back({"max_ground_depth_m", max_m_.value()});
    if (with_reaction_) summary.push_back({"max_ground_reaction_N", max_reaction_N_.value()});
  }

 private:
  double height_m_ = 0;
  bool with_reaction_ = false;
  RunningMax max_m_, max_reaction_N_;
  std::size_t column_ = 0, reaction_column_ = 0;
};

}  // namespace

std::unique_ptr<Probe> makeGroundProbe(const Scene& scene) {
  return std::make_unique<GroundProbe>(scene);
}

}  // namespace fissure
