#include "contact/path_truncation.h"

#include <algorithm>

#include "contact/contact_constraint.h"

namespace fissure {

namespace {
constexpr int kShortenings = 12;                 ///< passes that leave a stopped vertex a part of its path
constexpr double kKept = 0.8;                    ///< of the path up to the crossing
constexpr double kLeastSeparation = 1.0 / 1000;  ///< of a margin
}  // namespace

void PathTruncation::clear() {
  std::fill(stopped_by_.begin(), stopped_by_.end(), kNone);
  std::fill(rides_.begin(), rides_.end(), 0);
  stopped_.clear();
  left_overlap_ = false;
}

void PathTruncation::apply(std::span<SweptObstacle> obstacles, std::span<const double> inverse_masses,
                           const StepView& step, std::span<const Vec3> way_m, std::span<Vec3> motion_m) {
  if (!step.tool_bodies.empty()) start_m_.assign(step.positions_m.begin(), step.positions_m.end());
  stopTissue(obstacles, inverse_masses, step);
  if (left_overlap_ && holdTools(step)) {
    std::copy(start_m_.begin(), start_m_.end(), step.positions_m.begin());
    stopTissue(obstacles, inverse_masses, step);
  }
  for (std::size_t v = 0; v < stopped_by_.size(); ++v) {
    if (stopped_by_[v] == kNone) continue;
    if (stopped_by_[v] == kByGround) {
      const double into_m = std::min((way_m[v] + motion_m[v]).dot(ground_->normal), 0.0);
      motion_m[v] -= into_m * ground_->normal;
      stopped_.push_back({static_cast<int>(v), kGround, -into_m / inverse_masses[v] * ground_->normal});
      continue;
    }
    const SweptObstacle& obstacle = obstacles[stopped_by_[v]];
    const Vec3& at_m = obstacle.before_m[v - obstacle.first_vertex];
    const Vec3 tool_way_m =
        movedPose(step, obstacle.tool).toScene(at_m) - step.tools_before[obstacle.tool].pose.toScene(at_m);
    ToolBody led;
    ToolBody& body = step.tool_bodies.empty() ? led : step.tool_bodies[obstacle.tool];
    const double share = inverse_masses[v] / (inverse_masses[v] + body.inverse_mass_1_kg);
    const Vec3 change_m = share * (tool_way_m + body.motion_m - body.offset_m - way_m[v] - motion_m[v]);
    motion_m[v] += change_m;
    stopped_.push_back({static_cast<int>(v), obstacle.tool, change_m / inverse_masses[v], tool_way_m});
    body.motion_m -= body.inverse_mass_1_kg * stopped_.back().impulse_kg_m;
  }
  counts_.vertices += static_cast<long long>(stopped_.size());
  counts_.steps += stopped_.empty() ? 0 : 1;
  counts_.no_room_steps += left_overlap_ ? 1 : 0;
}

void PathTruncation::stopTissue(std::span<SweptObstacle> obstacles, std::span<const double> inverse_masses,
                                const StepView& step) {
  clear();
  bool stopped_more = true;
  for (int pass = 0; stopped_more; ++pass) {
    only_ride_ = pass >= kShortenings;
    left_overlap_ = false;
    stopped_more = ground_ && putOnGround(step.positions_m, inverse_masses);
    for (std::size_t o = 0; o < obstacles.size(); ++o) {
      SweptObstacle& obstacle = obstacles[o];
      obstacle.setNow(movedPose(step, obstacle.tool), step.positions_m);
      const double separation_m = kLeastSeparation * obstacle.margin_m;
      obstacle.pairs.gather(obstacle.path(), separation_m);
      crossings_.clear();
      obstacle.pairs.findCrossings(obstacle.path(), separation_m, crossings_);
      left_overlap_ |= !crossings_.empty();
      for (const SweptPair& pair : crossings_)
        stopped_more |= stop(obstacle, static_cast<int>(o), pair, step, inverse_masses);
    }
  }
}

// Whether one is there to be held.
bool PathTruncation::holdTools(const StepView& step) {
  bool any = false;
  for (std::size_t t = 0; t < step.tool_bodies.size(); ++t) {
    ToolBody& body = step.tool_bodies[t];
    if (!(body.inverse_mass_1_kg > 0)) continue;
    body.offset_m = step.tools_before[t].pose.position_m - step.tools_now[t].pose.position_m;
    any = true;
  }
  return any;
}

// Whether a vertex was moved. In the end, the ground comes before every tool.
bool PathTruncation::putOnGround(std::span<Vec3> positions_m, std::span<const double> inverse_masses) {
  bool moved = false;
  for (std::size_t v = 0; v < positions_m.size(); ++v) {
    if (inverse_masses[v] == 0 || !ground_->holdsInside(positions_m[v])) continue;
    positions_m[v] -= ground_->height_m(positions_m[v]) * ground_->normal;
    stopped_by_[v] = kByGround;
    rides_[v] = only_ride_ ? 1 : 0;
    moved = true;
  }
  return moved;
}

// Whether a vertex of the pair was moved. While paths are shortened any obstacle may; then each vertex is
// taken at most once by every obstacle, and kept by the first.
bool PathTruncation::stop(const SweptObstacle& obstacle, int index, const SweptPair& pair,
                          const StepView& step, std::span<const double> inverse_masses) {
  bool moved = false;
  for (int j = 0; j < 3; ++j) {
    const std::size_t of_body = pair.vertices[j], v = obstacle.first_vertex + of_body;
    if (inverse_masses[v] == 0 || (j > 0 && pair.vertices[j] == pair.vertices[j - 1])) continue;
    if (only_ride_ && rides_[v] && stopped_by_[v] <= index) continue;
    const double share = only_ride_ ? 0 : kKept * pair.time;
    const Vec3 &from_m = obstacle.before_m[of_body], &to_m = obstacle.now_m[of_body];
    step.positions_m[v] = movedPose(step, obstacle.tool).toScene(from_m + share * (to_m - from_m));
    if (single_precision_) roundToSingle(step.positions_m[v]);
    stopped_by_[v] = index;
    rides_[v] = only_ride_ ? 1 : 0;
    moved = true;
  }
  return moved;
}

double PathTruncation::toolWork_kg_m2() const {
  double work = 0;
  for (const Stopped& stopped : stopped_) work += stopped.impulse_kg_m.dot(stopped.tool_step_m);
  return work;
}

Vec3 PathTruncation::total(std::span<const double> factors) const {
  Vec3 sum_kg_m = Vec3::Zero();
  for (const Stopped& stopped : stopped_)
    if (stopped.tool != kGround) sum_kg_m += factors[stopped.vertex] * stopped.impulse_kg_m;
  return sum_kg_m;
}

Vec3 PathTruncation::ofTool(int tool, std::span<const double> factors) const {
  Vec3 sum_kg_m = Vec3::Zero();
  for (const Stopped& stopped : stopped_)
    if (stopped.tool == tool) sum_kg_m += factors[stopped.vertex] * stopped.impulse_kg_m;
  return sum_kg_m;
}

}  // namespace fissure
