#include "contact/vertex_sides.h"

#include "contact/box_entry.h"

namespace fissure {

namespace {

/// The face of the box that a point outside is farthest in front of, numbered as boxEntryFace does.
std::int8_t nearestFace(const Vec3& half_m, const Vec3& point_m) {
  int axis = 0;
  (point_m.cwiseAbs() - half_m).maxCoeff(&axis);
  return static_cast<std::int8_t>(2 * axis + (point_m[axis] > 0 ? 0 : 1));
}

}  // namespace

VertexSides::VertexSides(const Scene& scene, const std::vector<double>& margins_m) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    margins_m_.insert(margins_m_.end(), scene.bodies[b].rest.vertices_m.size(), margins_m.at(b));
  }
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    if (!scene.tools[t].box_size_m) continue;
    boxes_.push_back({.tool = static_cast<int>(t),
                      .half_m = 0.5 * *scene.tools[t].box_size_m,
                      .sides = std::vector<std::int8_t>(scene.vertexCount(), kNoSide)});
  }
}

void VertexSides::find(const StepView& step, std::span<const std::uint8_t> put_inside,
                       std::vector<ContactConstraint>& constraints) {
  for (Box& box : boxes_) {
    if (!put_inside.empty() && put_inside[box.tool]) continue;
    const Pose& now = step.tools_now[box.tool].pose;
    const Pose& before = step.tools_before[box.tool].pose;
    for (std::size_t v = 0; v < step.positions_m.size(); ++v) {
      const Vec3 reach_m = box.half_m + Vec3::Constant(margins_m_[v]);
      const Vec3 point_m = now.toBody(step.positions_m[v]);
      const Vec3 came_from_m = before.toBody(step.before_m[v]);
      std::int8_t& side = box.sides[v];
      if (!boxHolds(reach_m, came_from_m))
        side = static_cast<std::int8_t>(boxEntryFace(reach_m, came_from_m, point_m));
      else if (side == kNoSide && !boxHolds(box.half_m, came_from_m))  // starts within the margin
        side = nearestFace(box.half_m, came_from_m);
      if (side == kNoSide) continue;

      const int axis = side / 2;
      const double sign = side % 2 == 0 ? 1 : -1;
      const int vertex = static_cast<int>(v);
      const Vec3 face_point_m = sign * box.half_m[axis] * Vec3::Unit(axis);
      constraints.push_back({.vertices = {vertex, vertex, vertex},
                             .weights = {1, 0, 0},
                             .position_m = now.toScene(face_point_m),
                             .normal = now.rotateToScene(sign * Vec3::Unit(axis)),
                             .tool = box.tool,
                             .target_m = margins_m_[v]});
    }
  }
}

}  // namespace fissure
