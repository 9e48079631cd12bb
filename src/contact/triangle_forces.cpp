#include "contact/triangle_forces.h"

#include <array>

namespace fissure {

namespace {
template <typename Array>
Vec3 centroid(const Array& of_vertices, const Face& face) {
  return (of_vertices[face[0]] + of_vertices[face[1]] + of_vertices[face[2]]) / 3.0;
}
}  // namespace

TriangleForces::TriangleForces(const Scene& scene, std::vector<TriangleLaw> laws, double step_s)
    : laws_(std::move(laws)), step_s_(step_s) {
  for (const SceneBody& body : scene.bodies) {
    for (const Face& face : body.rest.faces) {
      rest_centroids_m_.push_back(centroid(body.rest.vertices_m, face));
      faces_.push_back(
          {face[0] + body.first_vertex, face[1] + body.first_vertex, face[2] + body.first_vertex});
    }
  }
  last_centroids_m_ = rest_centroids_m_;
}

void TriangleForces::evaluate(const ContactPatch& patch, State& state) {
  state.forces.assign(laws_.size(), ForceSample{});
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Face& face = faces_[i];
    const Vec3 now_m = centroid(state.positions_m, face);
    const Vec3 stepped_m = now_m - last_centroids_m_[i];
    last_centroids_m_[i] = now_m;
    if (!patch.vertex_contact[face[0]] && !patch.vertex_contact[face[1]] && !patch.vertex_contact[face[2]])
      continue;
    Vec3 normal = patch.face_normals[i];
    if (normal.isZero(0)) {
      normal = patch.vertex_normals[face[0]] + patch.vertex_normals[face[1]] + patch.vertex_normals[face[2]];
    }
    const double length = normal.norm();
    if (length > 0)
      normal /= length;  // opposing contacts that cancel leave the magnitude without a direction

    const Vec3 displacement = now_m - rest_centroids_m_[i];
    const double deformation_m = displacement.norm();
    const Vec3 direction = deformation_m > 0 ? Vec3(displacement / deformation_m) : Vec3::Zero();
    const std::array<double, 2> rates_m_s = {direction.dot(stepped_m) / step_s_,
                                             direction.dot(centroid(state.velocities_m_s, face))};
    for (std::size_t law = 0; law < laws_.size(); ++law) {
      const double rate_m_s = rates_m_s[laws_[law].rate == RateSource::differences ? 0 : 1];
      const LawForce force = laws_[law].law->at(deformation_m, rate_m_s);
      ForceSample& sum = state.forces[law];
      sum.force_on_tool_N -= (force.elastic_N + force.viscous_N) * normal;
      sum.elastic_N += force.elastic_N;
      sum.viscous_N += force.viscous_N;
      sum.adhesion_clamped += force.adhesion_clamped ? 1 : 0;
    }
  }
}

}  // namespace fissure
