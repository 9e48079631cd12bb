#pragma once

#include "base/probe.h"
#include "base/scene.h"

namespace fissure {

/// Series kinetic_energy and momentum(xyz) over all bodies, and volume(body), signed.
class BodyProbe : public Probe {
 public:
  explicit BodyProbe(const Scene& scene) : bodies_(scene.bodies) {}

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  std::vector<SceneBody> bodies_;  // their vertices follow the state
  std::size_t energy_column_ = 0;
  std::size_t momentum_column_ = 0;
  std::size_t volume_column_ = 0;
};

}  // namespace fissure
