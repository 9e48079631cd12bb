#include "slow_caster.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fissure::test {

namespace {

using LongVec3 = Eigen::Matrix<long double, 3, 1>;

constexpr double kLeastCosine = 1e-5;  // flatter rays meet a plane no better than to 1e-12 m

/// Bounds of rounding, metres, for bodies of centimetres; both casters lose where a ray is flat.
double distanceTolerance(double cosine) {
  return 1e-12 / std::abs(cosine);
}
double edgeBand(double cosine) {
  return 1e-11 + 1e-14 / std::abs(cosine);
}

/// Built only for failures: most of a million rays need none.
std::string describe(const Vec3& origin_m, const Vec3& direction, double limit_m,
                     const SlowCaster::Meeting* expected, const std::optional<SurfaceHit>& hit) {
  std::ostringstream text;
  text.precision(17);
  text << "from " << origin_m.transpose() << " along " << direction.transpose() << " up to " << limit_m;
  if (expected) text << ", first must be face " << expected->face << " at " << expected->distance_m;
  if (!expected) text << ", no triangle is there";
  if (hit) text << ", hit was face " << hit->face << " at " << hit->at.distance_m;
  if (!hit) text << ", nothing was hit";
  return text.str();
}

}  // namespace

SlowCaster::SlowCaster(const TriangleMesh& mesh) {
  for (const Face& face : mesh.faces) {
    std::array<LongVec3, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] = mesh.vertices_m[static_cast<std::size_t>(face[i])].cast<long double>();
    const LongVec3 normal =
        LongVec3(corner[1] - corner[0]).cross(LongVec3(corner[2] - corner[0])).normalized();
    Plane plane{normal.cast<double>(), corner[0].cast<double>(), {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const LongVec3 along = (corner[(i + 1) % 3] - corner[i]).normalized();
      plane.corners[i] = corner[i].cast<double>();
      plane.inwards[i] = normal.cross(along).cast<double>();
    }
    planes_.push_back(plane);
    const Vec3 middle_m = (plane.corners[0] + plane.corners[1] + plane.corners[2]) / 3;
    double radius_m = 0;
    for (const Vec3& corner_m : plane.corners) radius_m = std::max(radius_m, (corner_m - middle_m).norm());
    balls_.push_back({middle_m, std::pow(1.001 * radius_m + 1e-7, 2)});
  }
}

bool SlowCaster::meet(const Vec3& origin_m, const Vec3& direction, double limit_m) {
  meetings_.clear();
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const Vec3 to_middle_m = balls_[i].middle_m - origin_m;
    const double along_m = to_middle_m.dot(direction);
    if (to_middle_m.squaredNorm() - along_m * along_m > balls_[i].radius_squared) continue;
    const Plane& plane = planes_[i];
    const double height_m = plane.normal.dot(plane.corner - origin_m);
    const double cosine = plane.normal.dot(direction);
    if (std::abs(height_m) > (std::abs(cosine) + 1e-9) * (limit_m + 1e-6)) continue;
    if (std::abs(cosine) < kLeastCosine) return false;
    const double distance_m = height_m / cosine;
    const double tolerance_m = distanceTolerance(cosine);
    if (distance_m < -tolerance_m || distance_m > limit_m + tolerance_m) continue;
    const Vec3 point_m = origin_m + distance_m * direction;
    double margin_m = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < 3; ++e)
      margin_m = std::min(margin_m, plane.inwards[e].dot(point_m - plane.corners[e]));
    if (margin_m < -edgeBand(cosine)) continue;
    const bool within_ray = distance_m > tolerance_m && distance_m < limit_m - tolerance_m;
    meetings_.push_back(
        {static_cast<int>(i), distance_m, cosine, within_ray, within_ray && margin_m > edgeBand(cosine)});
  }
  std::sort(meetings_.begin(), meetings_.end(),
            [](const Meeting& a, const Meeting& b) { return a.distance_m < b.distance_m; });
  return true;
}

std::optional<std::string> SlowCaster::complaint(const Vec3& origin_m, const Vec3& direction, double limit_m,
                                                 const std::optional<SurfaceHit>& hit) {
  if (!meet(origin_m, direction, limit_m)) {
    ++undecided_;
    return std::nullopt;
  }
  for (std::size_t begin = 0, end = 0; begin < meetings_.size(); begin = end) {
    double tolerance_m = 0;
    bool certain = false, within_ray = true, alike = true;
    for (end = begin; end < meetings_.size(); ++end) {
      const Meeting& meeting = meetings_[end];
      const double reach_m = std::max(tolerance_m, edgeBand(meeting.cosine) / std::abs(meeting.cosine));
      if (meeting.distance_m > meetings_[begin].distance_m + reach_m) break;
      tolerance_m = reach_m;
      certain = certain || meeting.certain;
      within_ray = within_ray && meeting.within_ray;
      alike = alike && (meeting.cosine > 0) == (meetings_[begin].cosine > 0);
    }
    if (begin == 0 && !certain) ++on_edges_;
    for (std::size_t i = begin; hit && i < end; ++i) {
      const Meeting& meeting = meetings_[i];
      if (hit->face != meeting.face) continue;
      if (std::abs(hit->at.distance_m - meeting.distance_m) <= distanceTolerance(meeting.cosine) &&
          std::abs(hit->at.cosine - meeting.cosine) <= 1e-9)
        return std::nullopt;
    }
    if (certain || (within_ray && alike && end - begin > 1)) {
      return describe(origin_m, direction, limit_m, &meetings_[begin], hit);
    }
  }
  if (!hit) return std::nullopt;
  return describe(origin_m, direction, limit_m, nullptr, hit);
}

}  // namespace fissure::test
