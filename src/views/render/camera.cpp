#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace fissure {
namespace {

constexpr double farthest_drawable_m = 1e6;
constexpr double default_azimuth_deg = 25;
constexpr double default_elevation_deg = 20;
constexpr double default_filled = 0.84;  ///< leaves room for text and scale bar

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

Camera lookingAlong(const Vec3& back, const Vec3& up_hint) {
  Camera camera;
  camera.back = back.normalized();
  Vec3 right = up_hint.cross(camera.back);
  if (!(right.norm() > 1e-9 * up_hint.norm())) {
    right = (std::abs(camera.back.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitZ()).cross(camera.back);
  }
  camera.right = right.normalized();
  camera.up = camera.back.cross(camera.right);
  return camera;
}

}  // namespace

bool drawable(const Vec3& point_m) {
  return point_m.allFinite() && point_m.cwiseAbs().maxCoeff() < farthest_drawable_m;
}

std::optional<PicturePoint> Camera::project(const Vec3& point_m) const {
  const Vec3 seen = toCamera(point_m);
  const double depth_m = -seen.z();
  if (!(depth_m >= near_m())) {
    return std::nullopt;
  }
  const double half_height_m = depth_m * tan_half_height;
  return PicturePoint{(1 + seen.x() / (half_height_m * aspect())) * width_px / 2,
                      (1 - seen.y() / half_height_m) * height_px / 2, depth_m};
}

Eigen::Matrix4d Camera::viewMatrix() const {
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.block<1, 3>(0, 0) = right.transpose();
  view.block<1, 3>(1, 0) = up.transpose();
  view.block<1, 3>(2, 0) = back.transpose();
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * position_m;
  return view;
}

Eigen::Matrix4d Camera::projectionMatrix() const {
  const double range_m = far_m() - near_m();
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = 1 / (tan_half_height * aspect());
  projection(1, 1) = 1 / tan_half_height;
  projection(2, 2) = -(far_m() + near_m()) / range_m;
  projection(2, 3) = -2 * far_m() * near_m() / range_m;
  projection(3, 2) = -1;
  return projection;
}

double Camera::depthFromStored(double stored) const {
  return far_m() * near_m() / (far_m() - stored * (far_m() - near_m()));
}

Camera makeCamera(const CameraSettings& settings, int width_px, int height_px) {
  const Vec3 back = settings.position_m - settings.look_at_m;
  if (!(back.norm() > 1e-9)) {
    throw InputError(
        "record.frames.camera: position_m and look_at_m coincide, expected two different points");
  }
  Camera camera = lookingAlong(back, settings.up);
  camera.position_m = settings.position_m;
  camera.tan_half_height = std::tan(radians(settings.field_of_view_deg) / 2);
  camera.focus_m = back.norm();
  camera.width_px = width_px;
  camera.height_px = height_px;
  return camera;
}

Camera fitCamera(const Camera& orientation, std::span<const Vec3> points_m, double filled) {
  Camera camera = orientation;
  camera.position_m = Vec3::Zero();
  const double tan_y = filled * camera.tan_half_height;
  const double tan_x = tan_y * camera.aspect();
  // A camera at (cx, cy, cz) in its own axes sees a point inside the right edge when x - cx <= tan_x (cz -
  // z): each edge bounds one sum of the camera's coordinates by the largest of a sum of the points'.
  Vec3 lowest = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 highest = -lowest;
  double right = highest.x(), left = right, top = right, bottom = right;
  for (const Vec3& point_m : points_m) {
    const Vec3 p = camera.toCamera(point_m);
    lowest = lowest.cwiseMin(p);
    highest = highest.cwiseMax(p);
    right = std::max(right, p.x() + tan_x * p.z());
    left = std::max(left, -p.x() + tan_x * p.z());
    top = std::max(top, p.y() + tan_y * p.z());
    bottom = std::max(bottom, -p.y() + tan_y * p.z());
  }
  const Vec3 own((right - left) / 2, (top - bottom) / 2,
                 std::max((right + left) / (2 * tan_x), (top + bottom) / (2 * tan_y)));
  camera.position_m = own.x() * camera.right + own.y() * camera.up + own.z() * camera.back;
  camera.focus_m = own.z() - (lowest.z() + highest.z()) / 2;
  return camera;
}

std::vector<Vec3> pointsInView(const Scene& scene, const State& first) {
  std::vector<Vec3> points_m;
  std::copy_if(first.positions_m.begin(), first.positions_m.end(), std::back_inserter(points_m), drawable);
  for (std::size_t tool = 0; tool < std::min(scene.tools.size(), first.tools.size()); ++tool) {
    for (const Vec3& vertex_m : scene.tools[tool].surface.vertices_m) {
      const Vec3 placed_m = first.tools[tool].pose.toScene(vertex_m);
      if (drawable(placed_m)) {
        points_m.push_back(placed_m);
      }
    }
  }
  for (std::size_t clamp = 0; clamp < std::min(scene.clamps.size(), first.clamps.size()); ++clamp) {
    for (const Vec3& vertex_m : scene.clamps[clamp].handle.vertices_m) {
      const Vec3 placed_m = first.clamps[clamp].pose.toScene(vertex_m);
      if (drawable(placed_m)) {
        points_m.push_back(placed_m);
      }
    }
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& point_m : points_m) {
    box.extend(point_m);
  }
  if (points_m.empty() || !(box.diagonal().norm() > 0)) {
    const Vec3 middle = points_m.empty() ? Vec3::Zero() : points_m.front();
    return {middle - Vec3::Constant(0.05), middle + Vec3::Constant(0.05)};
  }
  if (scene.ground_height_m && std::abs(box.min().y() - *scene.ground_height_m) <= box.diagonal().norm()) {
    for (const double x : {box.min().x(), box.max().x()}) {
      for (const double z : {box.min().z(), box.max().z()}) {
        points_m.emplace_back(x, *scene.ground_height_m, z);
      }
    }
  }
  return points_m;
}

Camera defaultCamera(std::span<const Vec3> points_m, int width_px, int height_px, double field_of_view_deg) {
  const double azimuth = radians(default_azimuth_deg);
  const double elevation = radians(default_elevation_deg);
  Camera camera = lookingAlong(
      {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)},
      Vec3::UnitY());
  camera.tan_half_height = std::tan(radians(field_of_view_deg) / 2);
  camera.width_px = width_px;
  camera.height_px = height_px;
  return fitCamera(camera, points_m, default_filled);
}

Camera frameCamera(const FrameSettings& settings, std::span<const Vec3> points_m) {
  return settings.camera ? makeCamera(*settings.camera, settings.width_px, settings.height_px)
                         : defaultCamera(points_m, settings.width_px, settings.height_px);
}

CameraSettings settingsOf(const Camera& camera) {
  const double field_of_view_deg = 2 * std::atan(camera.tan_half_height) * 180 / std::numbers::pi;
  return {camera.position_m, camera.position_m - camera.focus_m * camera.back, camera.up, field_of_view_deg};
}

}  // namespace fissure
