#include <cmath>

#include "measure/penetration.h"
#include "measure/probe_makers.h"
#include "measure/soundness.h"

namespace fissure {

namespace {

/// The scalars of Soundness for a scene without tools; with tools the penetration probe has them.
class SoundnessProbe : public Probe {
 public:
  explicit SoundnessProbe(const Scene& scene)
      : meter_(scene, {}), soundness_(scene), bodies_(scene.bodies.size()) {}

  void declare(RecordLayout&) override {}
  void sample(const State& state, RecordRow&) override {
    if (std::isnan(meter_.measure(state).depth_m)) return;
    for (std::size_t b = 0; b < bodies_.size(); ++b) bodies_[b].inverted = meter_.inverted()[b];
    soundness_.add(state, bodies_);
  }
  void summarize(Summary& summary) const override { soundness_.summarize(summary); }

 private:
  PenetrationMeter meter_;
  Soundness soundness_;
  std::vector<Soundness::BodyStep> bodies_;
};

}  // namespace

std::unique_ptr<Probe> makeSoundnessProbe(const Scene& scene) {
  return std::make_unique<SoundnessProbe>(scene);
}

}  // namespace fissure
