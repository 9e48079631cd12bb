#include "contact/triangle_deformation.h"

namespace fissure {

TriangleDeformation::TriangleDeformation(const Scene& scene, DeformationKind kind,
                                         const std::vector<RateSource>& sources, double step_s)
    : kind_(kind), step_s_(step_s) {
  for (const RateSource source : sources)
    (source == RateSource::differences ? differences_ : velocities_) = true;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    if (kind == DeformationKind::corotated) fits_.emplace_back(body);
    for (const Face& face : body.rest.faces) {
      const std::vector<Vec3>& rest_m = body.rest.vertices_m;
      rest_m_.push_back((rest_m[face[0]] + rest_m[face[1]] + rest_m[face[2]]) / 3.0);
      const int first = body.first_vertex;
      triangles_.push_back({{face[0] + first, face[1] + first, face[2] + first}, static_cast<int>(b)});
    }
  }
  now_m_ = rest_m_;
  if (differences_) last_m_ = rest_m_;
}

Vec3 TriangleDeformation::centroid(std::size_t triangle, const std::vector<Vec3>& of_vertices) const {
  const Face& face = triangles_[triangle].face;
  return (of_vertices[face[0]] + of_vertices[face[1]] + of_vertices[face[2]]) / 3.0;
}

void TriangleDeformation::update(const State& state) {
  for (RigidFit& fit : fits_) {
    fit.fit(state.positions_m);
    if (velocities_) fit.fitRates(state.velocities_m_s);
    ++rigid_fits_;
  }
  if (differences_) now_m_.swap(last_m_);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    now_m_[i] = centroid(i, state.positions_m);
    if (kind_ == DeformationKind::corotated) now_m_[i] = fits_[triangles_[i].body].toRest(now_m_[i]);
  }
}

Vec3 TriangleDeformation::rate(std::size_t triangle, RateSource source, const State& state) const {
  if (source == RateSource::differences) return (now_m_[triangle] - last_m_[triangle]) / step_s_;
  Vec3 velocity_m_s = centroid(triangle, state.velocities_m_s);
  if (kind_ == DeformationKind::paper) return velocity_m_s;
  return fits_[triangles_[triangle].body].velocityInRest(centroid(triangle, state.positions_m), velocity_m_s);
}

}  // namespace fissure
