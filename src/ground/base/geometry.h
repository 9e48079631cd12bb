#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace fissure {

using Vec3 = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;  ///< unit quaternion; stored as x, y, z, w wherever it is written down
using Mat3 = Eigen::Matrix3d;

/// The pose of a rigid body: maps points and directions of its own frame to the scene frame.
struct Pose {
  Vec3 position_m = Vec3::Zero();
  Quat orientation = Quat::Identity();

  /// Points in metres, from the body's frame to the scene frame and back.
  Vec3 toScene(const Vec3& point_in_body_m) const { return position_m + orientation * point_in_body_m; }
  Vec3 toBody(const Vec3& point_in_scene_m) const {
    return orientation.conjugate() * (point_in_scene_m - position_m);
  }
  /// Directions (vectors without a position), from the body's frame to the scene frame and back.
  Vec3 rotateToScene(const Vec3& direction_in_body) const { return orientation * direction_in_body; }
  Vec3 rotateToBody(const Vec3& direction_in_scene) const {
    return orientation.conjugate() * direction_in_scene;
  }
};

/// Corner indices of a triangle, counter-clockwise seen from outside.
using Face = std::array<int, 3>;

/// An indexed triangle surface, metres. A soft body's is closed, with outward faces.
struct TriangleMesh {
  std::vector<Vec3> vertices_m;
  std::vector<Face> faces;
};

}  // namespace fissure
