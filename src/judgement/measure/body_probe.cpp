#include <algorithm>

#include "measure/probe_makers.h"
#include "measure/statistics.h"
#include "mesh/check.h"

namespace fissure {

namespace {

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

}  // namespace

void BodyProbe::declare(RecordLayout& layout) {
  energy_column_ = layout.add({.name = "kinetic_energy",
                               .units = "J",
                               .long_name = "kinetic energy of all tissue vertices",
                               .axes = {}});
  layout.addAxis(xyzAxis());
  momentum_column_ = layout.add({.name = "momentum",
                                 .units = "kg m s-1",
                                 .long_name = "linear momentum of all tissue vertices, scene frame",
                                 .axes = {"xyz"}});
  RecordAxis body_axis{"body", {}};
  for (const SceneBody& body : bodies_) body_axis.labels.push_back(body.name);
  layout.addAxis(body_axis);
  volume_column_ = layout.add({.name = "volume",
                               .units = "m3",
                               .long_name = "volume inside the surface, negative when inside out",
                               .axes = {"body"}});
}

void BodyProbe::sample(const State& state, RecordRow& row) {
  double energy_J = 0;
  Vec3 momentum = Vec3::Zero();
  for (std::size_t i = 0; i < state.masses_kg.size(); ++i) {
    energy_J += 0.5 * state.masses_kg[i] * state.velocities_m_s[i].squaredNorm();
    momentum += state.masses_kg[i] * state.velocities_m_s[i];
  }
  if (state.volume) {  // the vertices inside too
    energy_J = state.volume->kinetic_J;
    momentum = state.volume->momentum_kg_m_s;
  }
  row[energy_column_] = energy_J;
  writeVector(momentum, momentum_column_, row);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    std::vector<Vec3>& vertices = bodies_[b].rest.vertices_m;
    std::copy_n(state.positions_m.begin() + bodies_[b].first_vertex, vertices.size(), vertices.begin());
    row[volume_column_ + b] = signedVolume_m3(bodies_[b].rest);
  }
}

void BodyProbe::summarize(Summary& summary) const {
  long long fixed = 0;
  for (const SceneBody& body : bodies_) fixed += static_cast<long long>(body.fixed_vertices.size());
  if (fixed > 0) summary.push_back({"fixed_vertices", fixed});
}

std::unique_ptr<Probe> makeBodyProbe(const Scene& scene) {
  return std::make_unique<BodyProbe>(scene);
}

}  // namespace fissure
