#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/geometry.h"
#include "base/scene.h"
#include "base/state.h"
#include "scenario/scenario.h"

namespace fissure {

/// A point in the picture, in pixels from the left and the top edge (pixel i covers [i, i + 1)), with its
/// distance from the camera's plane.
struct PicturePoint {
  double x_px = 0;
  double y_px = 0;
  double depth_m = 0;
};

/// A pinhole camera, which looks along -back. right, up and back are its unit axes in the scene frame.
struct Camera {
  Vec3 position_m = Vec3::Zero();
  Vec3 right = Vec3::UnitX();
  Vec3 up = Vec3::UnitY();
  Vec3 back = Vec3::UnitZ();
  double tan_half_height = 1;  ///< tangent of half the vertical field of view
  double focus_m = 1;          ///< distance of the point looked at, at which the scale bar is valid
  int width_px = 1;
  int height_px = 1;

  /// The nearest and farthest depths that are drawn, 1/50 and 50 times the focus, for which 24 bits of depth
  /// resolve 1e-5 of the focus.
  double near_m() const { return focus_m / 50; }
  double far_m() const { return focus_m * 50; }
  double aspect() const { return static_cast<double>(width_px) / height_px; }
  /// Height of a pixel at this depth, metres.
  double pixelSize_m(double depth_m) const { return 2 * depth_m * tan_half_height / height_px; }

  /// Maps a point from the scene frame to the camera frame (x right, y up, z back), metres.
  Vec3 toCamera(const Vec3& point_m) const {
    const Vec3 offset = point_m - position_m;
    return {right.dot(offset), up.dot(offset), back.dot(offset)};
  }
  /// The place of a point (scene frame) in the picture, which may be outside of its edges; no value when the
  /// point is nearer than near_m() or behind the camera.
  std::optional<PicturePoint> project(const Vec3& point_m) const;
  /// OpenGL's matrices (column major) from the scene frame to the camera frame, and from there to clip space.
  Eigen::Matrix4d viewMatrix() const;
  Eigen::Matrix4d projectionMatrix() const;
  /// The depth in metres that OpenGL stores as `stored`, 0..1.
  double depthFromStored(double stored) const;
};

/// True for a point that can be drawn: finite, and not so far away that float arithmetic overflows.
bool drawable(const Vec3& point_m);

/// The camera of a scenario's settings. `up` need not be orthogonal to the viewing direction; where the two
/// are parallel, another axis replaces it. Throws InputError when position_m and look_at_m coincide.
Camera makeCamera(const CameraSettings& settings, int width_px, int height_px);

/// The closest camera with the axes of `orientation` that has all points in the centred part `filled` (0..1)
/// of the picture's width and height. Its focus is the depth of the middle of the points' bounding box in the
/// camera frame.
Camera fitCamera(const Camera& orientation, std::span<const Vec3> points_m, double filled);

/// The points (scene frame) that a picture of the first state must show: all drawable vertices of bodies and
/// tools, and the ground below them where it is nearer than their extent. Without any, the corners of a box
/// of 0.1 m around the origin.
std::vector<Vec3> pointsInView(const Scene& scene, const State& first);

/// The default camera: it looks at the points from the front (along -z), 25 degrees from the right and 20
/// from above.
Camera defaultCamera(std::span<const Vec3> points_m, int width_px, int height_px,
                     double field_of_view_deg = CameraSettings{}.field_of_view_deg);

/// The camera of a scenario's frames: the stated one, or the default one for these points.
Camera frameCamera(const FrameSettings& settings, std::span<const Vec3> points_m);

/// Settings from which makeCamera() makes this camera, up to rounding.
CameraSettings settingsOf(const Camera& camera);

}  // namespace fissure
