#include "contact/node_rays.h"

#include <algorithm>

namespace fissure {

namespace {

double extentOf(const TriangleMesh& mesh) {
  Vec3 low = mesh.vertices_m.front(), high = low;
  for (const Vec3& v : mesh.vertices_m) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

}  // namespace

NodeRays::NodeRays(const Scene& scene, std::vector<double> margins_m, std::optional<double> ray_length_m)
    : ray_length_m_(ray_length_m) {
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const ToolNodes& nodes = scene.tools[t].nodes;
    for (int i = 0; i < nodes.size(); ++i) {
      nodes_.push_back({static_cast<int>(t), nodes.positions_m[i], nodes.normals[i]});
    }
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    bodies_.push_back({.tree = FaceTree(body.rest.vertices_m, body.rest.faces),
                       .faces = body.rest.faces,
                       .first_vertex = body.first_vertex,
                       .first_face = body.first_face,
                       .vertex_count = static_cast<int>(body.rest.vertices_m.size()),
                       .extent_m = extentOf(body.rest),
                       .margin_m = margins_m.at(b)});
  }
}

void NodeRays::cast(int body_index, std::span<const Vec3> positions_m, std::span<const Vec3> before_m,
                    const std::vector<ToolState>& tools_now, const std::vector<ToolState>& tools_before,
                    std::vector<NodeCandidate>& candidates) {
  Body& body = bodies_[body_index];
  const auto body_positions_m = positions_m.subspan(body.first_vertex, body.vertex_count);
  body.tree.refit(body_positions_m);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    const Pose& pose = tools_now[node.tool].pose;
    const Vec3 position_m = pose.toScene(node.position_m);
    const Vec3 normal = pose.rotateToScene(node.normal);
    const Vec3 start_m = position_m + body.margin_m * normal;
    if (!body.tree.boxHolds(start_m)) continue;  // outside the body: its first hit could only enter

    const Vec3 travel_m = position_m - tools_before[node.tool].pose.toScene(node.position_m);
    const double length_m = std::max(ray_length_m_.value_or(body.extent_m), travel_m.norm()) + body.margin_m;
    ++rays_;
    const auto hit = body.tree.firstHit(Ray(start_m, -normal, length_m), body_positions_m, tests_);
    if (!hit || hit->at.cosine < 0) continue;

    NodeCandidate candidate{.node = static_cast<int>(i), .body = body_index, .face = hit->face};
    candidate.constraint = {.vertices = body.faces[hit->face],
                            .weights = hit->at.weights,
                            .position_m = position_m,
                            .normal = normal,
                            .target_m = body.margin_m,
                            .tool = node.tool};
    Vec3 tissue_travel_m = Vec3::Zero();
    for (int j = 0; j < 3; ++j) {
      int& vertex = candidate.constraint.vertices[j];
      vertex += body.first_vertex;
      tissue_travel_m += hit->at.weights[j] * (positions_m[vertex] - before_m[vertex]);
    }
    candidate.depth_m = hit->at.distance_m - body.margin_m;
    candidate.approach_m = (travel_m - tissue_travel_m).dot(normal);
    candidates.push_back(candidate);
  }
}

}  // namespace fissure
