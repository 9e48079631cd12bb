#pragma once

#include <span>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/swept_pairs.h"

namespace fissure {

/// One tool as an obstacle of one body. Everything is in the tool's frame, in which the tool rests.
struct SweptObstacle {
  SweptObstacle(const Scene& scene, std::size_t of_tool, std::size_t of_body, double margin)
      : tool(static_cast<int>(of_tool)),
        body(of_body),
        first_vertex(static_cast<std::size_t>(scene.bodies[of_body].first_vertex)),
        first_face(static_cast<std::size_t>(scene.bodies[of_body].first_face)),
        margin_m(margin),
        pairs(scene.tools[of_tool], scene.bodies[of_body]),
        before_m(scene.bodies[of_body].rest.vertices_m.size()),
        now_m(before_m.size()) {}

  int tool;
  std::size_t body;
  std::size_t first_vertex, first_face;  ///< offsets of the body in [vertex] and [face] arrays
  double margin_m;                       ///< distance at which contacts hold the body in front of the tool
  SweptPairs pairs;
  std::vector<Vec3> before_m, now_m;  ///< positions of the body's vertices when the step began and now

  TissuePath path() const { return {before_m, now_m}; }
  /// Sets before_m (or now_m) from `positions_m` of all bodies, scene frame, and the pose of the tool.
  void setBefore(const Pose& tool_pose, std::span<const Vec3> positions_m) {
    const ToToolFrame to_tool(tool_pose);
    for (std::size_t v = 0; v < before_m.size(); ++v) before_m[v] = to_tool(positions_m[first_vertex + v]);
  }
  void setNow(const Pose& tool_pose, std::span<const Vec3> positions_m) {
    const ToToolFrame to_tool(tool_pose);
    for (std::size_t v = 0; v < now_m.size(); ++v) now_m[v] = to_tool(positions_m[first_vertex + v]);
  }
  /// The same where only the vertices `moved`, indices in the body, have changed.
  void setNow(const Pose& tool_pose, std::span<const Vec3> positions_m, std::span<const int> moved) {
    const ToToolFrame to_tool(tool_pose);
    for (const int v : moved) now_m[v] = to_tool(positions_m[first_vertex + v]);
  }

 private:
  /// As Pose::toBody, with a precomputed matrix for many points.
  struct ToToolFrame {
    explicit ToToolFrame(const Pose& pose)
        : rotation(pose.orientation.conjugate().toRotationMatrix()), origin_m(pose.position_m) {}
    Vec3 operator()(const Vec3& point_m) const { return rotation * (point_m - origin_m); }
    Mat3 rotation;
    Vec3 origin_m;
  };
};

}  // namespace fissure
