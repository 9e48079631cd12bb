#include "contact/rim_edges.h"

#include <algorithm>

#include "contact/box_entry.h"

namespace fissure {

RimEdges::RimEdges(const Scene& scene, const std::vector<double>& margins_m, double max_displacement_m)
    : max_displacement_m_(max_displacement_m) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    for (const Face& face : body.rest.faces) {
      for (int j = 0; j < 3; ++j) {
        const int from = face[j], to = face[(j + 1) % 3];
        if (from < to)  // a closed surface has each edge once in either direction
          edges_.push_back({{from + body.first_vertex, to + body.first_vertex}, margins_m.at(b)});
      }
    }
  }
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    if (!scene.tools[t].box_size_m) continue;
    Box box{.tool = static_cast<int>(t), .half_m = 0.5 * *scene.tools[t].box_size_m};
    box.half_m.minCoeff(&box.thin_axis);
    boxes_.push_back(box);
  }
  local_m_.resize(scene.vertexCount());
  local_before_m_.resize(scene.vertexCount());
}

void RimEdges::find(const StepView& step, std::span<const std::uint8_t> put_inside,
                    std::vector<ContactConstraint>& constraints) {
  for (const Box& box : boxes_) {
    if (!put_inside.empty() && put_inside[box.tool]) continue;
    for (std::size_t v = 0; v < step.positions_m.size(); ++v) {
      local_m_[v] = step.tools_now[box.tool].pose.toBody(step.positions_m[v]);
      local_before_m_[v] = step.tools_before[box.tool].pose.toBody(step.before_m[v]);
    }
    findOn(box, step.tools_now[box.tool], constraints);
  }
}

void RimEdges::findOn(const Box& box, const ToolState& tool,
                      std::vector<ContactConstraint>& constraints) const {
  const int thin = box.thin_axis;
  for (const Edge& edge : edges_) {
    const Vec3& a = local_m_[edge.vertices[0]];
    const Vec3& b = local_m_[edge.vertices[1]];
    const Vec3 reach_m = box.half_m + Vec3::Constant(edge.margin_m);
    if (std::min(a[thin], b[thin]) >= reach_m[thin] || std::max(a[thin], b[thin]) <= -reach_m[thin]) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == thin) continue;
      for (const double sign : {1.0, -1.0}) {
        const double a_beyond_m = sign * a[axis] - box.half_m[axis];
        const double b_beyond_m = sign * b[axis] - box.half_m[axis];
        if (!(a_beyond_m * b_beyond_m < 0)) continue;
        const double share = a_beyond_m / (a_beyond_m - b_beyond_m);
        const Vec3 point_m = a + share * (b - a);
        const int along = 3 - thin - axis;
        if (std::abs(point_m[along]) > box.half_m[along] || std::abs(point_m[thin]) >= reach_m[thin])
          continue;
        const Vec3& a_before = local_before_m_[edge.vertices[0]];
        const Vec3 came_from_m = a_before + share * (local_before_m_[edge.vertices[1]] - a_before);
        int face = 2 * thin + (came_from_m[thin] < 0 ? 1 : 0);
        const bool was_inside = boxHolds(reach_m, came_from_m);
        if (!was_inside) face = boxEntryFace(reach_m, came_from_m, point_m);
        if (face < 0) continue;
        // Deeper than what contacts leave, the tool was put into the tissue: its nodes push it free.
        if (was_inside && reach_m[thin] - std::abs(came_from_m[thin]) > 2 * edge.margin_m) continue;
        const double side = face % 2 == 0 ? 1 : -1;
        const Vec3 normal = side * Vec3::Unit(face / 2);
        const double gap_m = side * point_m[face / 2] - box.half_m[face / 2];
        const double approach_m = std::max(0.0, side * (came_from_m[face / 2] - point_m[face / 2]));
        constraints.push_back(
            {.vertices = {edge.vertices[0], edge.vertices[1], edge.vertices[1]},
             .weights = {1 - share, share, 0},
             .position_m = tool.pose.toScene(box.half_m[face / 2] * normal),
             .normal = tool.pose.rotateToScene(normal),
             .tool = box.tool,
             .target_m = std::min(edge.margin_m, gap_m + approach_m + max_displacement_m_)});
      }
    }
  }
}

}  // namespace fissure
