#include "contact/node_rays.h"

#include <algorithm>
#include <cmath>

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

/// Whether the tissue triangle faces the node's side of its box at least as much as any other side.
bool facesSide(const Vec3& side_normal, const Pose& tool, const Face& face,
               std::span<const Vec3> positions_m) {
  const Vec3& corner_m = positions_m[face[0]];
  const Vec3 outward = (positions_m[face[1]] - corner_m).cross(positions_m[face[2]] - corner_m);
  const Vec3 in_tool = tool.rotateToBody(outward);
  constexpr double rounding = 1e-9;
  return -in_tool.dot(side_normal) >= (1 - rounding) * in_tool.cwiseAbs().maxCoeff();
}

}  // namespace

NodeRays::NodeRays(const Scene& scene, std::vector<double> margins_m, std::optional<double> ray_length_m)
    : ray_length_m_(ray_length_m) {
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const ToolNodes& nodes = scene.tools[t].nodes;
    for (int i = 0; i < nodes.size(); ++i) {
      nodes_.push_back({static_cast<int>(t), nodes.positions_m[i], nodes.normals[i], nodes.all_sides});
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

void NodeRays::Body::noteTravel(const Tissue& tissue) {
  mean_travel_m = Vec3::Zero();
  double largest_squared = 0;
  for (std::size_t v = 0; v < tissue.now_m.size(); ++v) {
    const Vec3 travel_m = tissue.now_m[v] - tissue.before_m[v];
    mean_travel_m += travel_m;
    largest_squared = std::max(largest_squared, travel_m.squaredNorm());
  }
  mean_travel_m /= static_cast<double>(tissue.now_m.size());
  largest_travel_m = std::sqrt(largest_squared);
}

void NodeRays::cast(int body_index, const StepView& step, std::vector<NodeCandidate>& candidates) {
  Body& body = bodies_[body_index];
  const Tissue tissue{.now_m = step.positions_m.subspan(body.first_vertex, body.vertex_count),
                      .before_m = step.before_m.subspan(body.first_vertex, body.vertex_count)};
  body.tree.refit(tissue.now_m);
  body.noteTravel(tissue);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    const Pose& pose = step.tools_now[node.tool].pose;
    const Path path{.from_m = step.tools_before[node.tool].pose.toScene(node.position_m),
                    .to_m = pose.toScene(node.position_m),
                    .normal = pose.rotateToScene(node.normal)};
    std::optional<SurfaceHit> hit = hitBehind(body, path, tissue);
    if (!hit) hit = hitOnPath(body, path, tissue);
    if (!hit) continue;
    if (node.all_sides && !facesSide(node.normal, pose, body.faces[hit->face], tissue.now_m)) continue;

    NodeCandidate candidate{.node = static_cast<int>(i), .body = body_index, .face = hit->face};
    candidate.constraint = {.vertices = body.faces[hit->face],
                            .weights = hit->at.weights,
                            .position_m = path.to_m,
                            .normal = path.normal,
                            .tool = node.tool,
                            .target_m = body.margin_m};
    const Face& face = body.faces[hit->face];
    const Vec3 point_m = pointOf(face, hit->at.weights, tissue.now_m);
    const Vec3 tissue_travel_m = point_m - pointOf(face, hit->at.weights, tissue.before_m);
    for (int& vertex : candidate.constraint.vertices) vertex += body.first_vertex;
    candidate.depth_m = (path.to_m - point_m).dot(path.normal);
    candidate.approach_m = (path.to_m - path.from_m - tissue_travel_m).dot(path.normal);
    candidates.push_back(candidate);
  }
}

// Back into the tool and out behind it. Only an exit tells that the ray began inside the tissue.
std::optional<SurfaceHit> NodeRays::hitBehind(const Body& body, const Path& path, const Tissue& tissue) {
  const Vec3 start_m = path.to_m + body.margin_m * path.normal;
  if (!body.tree.boxHolds(start_m)) return std::nullopt;  // outside the body: its first hit could only enter
  const double travel_m = (path.to_m - path.from_m).norm();
  const double length_m = std::max(ray_length_m_.value_or(body.extent_m), travel_m) + body.margin_m;
  ++rays_;
  const auto hit = body.tree.firstHit(Ray(start_m, -path.normal, length_m), tissue.now_m, tests_);
  return hit && hit->at.cosine > 0 ? hit : std::nullopt;
}

// The way of the step as the tissue saw it: its start is carried along with the tissue, first with the whole
// body, then with the triangle that this finds. Counts where the node's face leads into the surface.
std::optional<SurfaceHit> NodeRays::hitOnPath(const Body& body, const Path& path, const Tissue& tissue) {
  if ((path.to_m - path.from_m).norm() + body.largest_travel_m <= body.margin_m) return std::nullopt;
  Vec3 carried_m = body.mean_travel_m;
  std::optional<SurfaceHit> hit;
  for (int pass = 0; pass < 2; ++pass) {
    const Vec3 start_m = path.from_m + carried_m;
    const Vec3 way_m = path.to_m - start_m;
    const double length_m = way_m.norm();
    if (!(length_m > body.margin_m) || !(way_m.dot(path.normal) > 0)) return std::nullopt;
    ++rays_;
    hit = body.tree.firstHit(Ray(start_m, way_m / length_m, length_m), tissue.now_m, tests_);
    if (!hit || hit->at.cosine > 0) return std::nullopt;
    const Face& face = body.faces[hit->face];
    carried_m =
        pointOf(face, hit->at.weights, tissue.now_m) - pointOf(face, hit->at.weights, tissue.before_m);
  }
  return hit;
}

}  // namespace fissure
