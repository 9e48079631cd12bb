#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/geometry.h"
#include "base/scene.h"
#include "base/state.h"
#include "scenario/scenario.h"

namespace fissure {

/// A point in the picture: pixels from the left and from the top edge (pixel i covers [i, i + 1)), and its
/// distance from the camera's plane.
struct PicturePoint {
  double x_px = 0;
  double y_px = 0;
  double depth_m = 0;
};

/// A pinhole camera. right, up and back are its unit axes in the scene's frame; it looks along -back.
struct Camera {
  Vec3 position_m = Vec3::Zero();
  Vec3 right = Vec3::UnitX();
  Vec3 up = Vec3::UnitY();
  Vec3 back = Vec3::UnitZ();
  double tan_half_height = 1;  ///< tangent of half the vertical field of view
  double focus_m = 1;          ///< distance of the point looked at: where the scale bar holds
  int width_px = 1;
  int height_px = 1;

  /// Nothing nearer or farther is drawn: 1/50 and 50 times the focus keep 24 bits of depth finer than 1e-5
  /// focus.
  double near_m() const { return focus_m / 50; }
  double far_m() const { return focus_m * 50; }
  double aspect() const { return static_cast<double>(width_px) / height_px; }
  /// Height of a pixel at this depth.
  double pixelSize_m(double depth_m) const { return 2 * depth_m * tan_half_height / height_px; }

  /// Scene to camera frame: x right, y up, z back; metres.
  Vec3 toCamera(const Vec3& point_m) const {
    const Vec3 offset = point_m - position_m;
    return {right.dot(offset), up.dot(offset), back.dot(offset)};
  }
  /// Nothing when the point is nearer than near_m() or behind the camera; may lie outside the picture.
  std::optional<PicturePoint> project(const Vec3& point_m) const;
  /// OpenGL's matrices (column major): scene to camera frame, camera frame to clip space.
  Eigen::Matrix4d viewMatrix() const;
  Eigen::Matrix4d projectionMatrix() const;
  /// The depth that OpenGL stores as `stored` in 0..1.
  double depthFromStored(double stored) const;
};

/// True for a point that can be drawn: finite, and not flung so far that float arithmetic overflows.
bool drawable(const Vec3& point_m);

/// A camera as the scenario states it. `up` need not be orthogonal to the view; where it is parallel to it,
/// another axis takes its place. Throws InputError when position_m and look_at_m coincide.
Camera makeCamera(const CameraSettings& settings, int width_px, int height_px);

/// The closest camera that looks along -back (axes of `orientation`) and has all points within `filled`
/// (0..1) of the picture's half width and half height, centred. Its focus is the depth of the middle of the
/// points' bounding box in the camera frame.
Camera fitCamera(const Camera& orientation, std::span<const Vec3> points_m, double filled);

/// What a picture of the first state must hold: all drawable vertices of bodies and tools, and below them the
/// ground where it is nearer than their own extent. Without any, a box of 0.1 m around the origin.
std::vector<Vec3> pointsInView(const Scene& scene, const State& first);

/// The default camera: pointsInView from the front (looking along -z), 25 degrees from the right and 20 from
/// above.
Camera defaultCamera(std::span<const Vec3> points_m, int width_px, int height_px,
                     double field_of_view_deg = CameraSettings{}.field_of_view_deg);

/// The camera of a scenario's frames: theirs, or the default one.
Camera frameCamera(const FrameSettings& settings, std::span<const Vec3> points_m);

/// What makeCamera() makes this camera of, up to rounding.
CameraSettings settingsOf(const Camera& camera);

}  // namespace fissure
