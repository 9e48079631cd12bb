#include "contact/triangle_forces.h"

namespace fissure {

namespace {
template <typename Array>
Vec3 centroid(const Array& of_vertices, const Face& face) {
  return (of_vertices[face[0]] + of_vertices[face[1]] + of_vertices[face[2]]) / 3.0;
}
}  // namespace

TriangleForces::TriangleForces(const Scene& scene, std::vector<std::unique_ptr<ForceLaw>> laws)
    : laws_(std::move(laws)) {
  for (const SceneBody& body : scene.bodies) {
    for (const Face& face : body.rest.faces) {
      rest_centroids_m_.push_back(centroid(body.rest.vertices_m, face));
      faces_.push_back(
          {face[0] + body.first_vertex, face[1] + body.first_vertex, face[2] + body.first_vertex});
    }
  }
}

void TriangleForces::evaluate(const ContactPatch& patch, State& state) const {
  state.forces.assign(laws_.size(), ForceSample{});
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Face& face = faces_[i];
    if (!patch.vertex_contact[face[0]] && !patch.vertex_contact[face[1]] && !patch.vertex_contact[face[2]])
      continue;
    Vec3 normal = patch.face_normals[i];
    if (normal.isZero(0)) {
      normal = patch.vertex_normals[face[0]] + patch.vertex_normals[face[1]] + patch.vertex_normals[face[2]];
    }
    const double length = normal.norm();
    if (length > 0)
      normal /= length;  // opposing contacts that cancel leave the magnitude without a direction

    const Vec3 displacement = centroid(state.positions_m, face) - rest_centroids_m_[i];
    const double deformation_m = displacement.norm();
    const double rate_m_s =
        deformation_m > 0 ? displacement.dot(centroid(state.velocities_m_s, face)) / deformation_m : 0.0;
    for (std::size_t law = 0; law < laws_.size(); ++law) {
      const LawForce force = laws_[law]->at(deformation_m, rate_m_s);
      ForceSample& sum = state.forces[law];
      sum.force_on_tool_N -= (force.elastic_N + force.viscous_N) * normal;
      sum.elastic_N += force.elastic_N;
      sum.viscous_N += force.viscous_N;
      sum.adhesion_clamped += force.adhesion_clamped ? 1 : 0;
    }
  }
}

}  // namespace fissure
