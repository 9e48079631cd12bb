#include "motion/scripted_motion.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/rotation.h"
#include "motion/timing.h"

namespace fissure {
namespace {

/// A written quaternion is rounded; a zero one says nothing.
Quat unit(const Quat& written, const std::string& where) {
  if (!(written.norm() > 1e-6) || !std::isfinite(written.norm()))
    throw InputError(where + ": no rotation, expected a unit quaternion x, y, z, w");
  return written.normalized();
}

double positive(double value, const std::string& where) {
  if (!(value > 0) || !std::isfinite(value)) throw InputError(where + ": expected a value above 0");
  return value;
}

double holdDuration_s(const MotionSegment& segment, const std::string& where) {
  if (segment.move_to_m || segment.rotate_to || segment.openTo() || segment.speed_m_s || segment.duration_s)
    throw InputError(where + ": hold_s stands beside a movement, expected it alone");
  return positive(*segment.hold_s, where + ".hold_s");
}

double moveDuration_s(const MotionSegment& segment, double distance_m, const std::string& where) {
  if (!segment.move_to_m && !segment.rotate_to && !segment.openTo())
    throw InputError(where + ": nothing to do, expected move_to_m, rotate_to or hold_s");
  if (segment.duration_s && segment.speed_m_s)
    throw InputError(where + ": both speed_m_s and duration_s, expected one of them");
  if (segment.duration_s) return positive(*segment.duration_s, where + ".duration_s");
  // A speed in metres a second says nothing about a turn on the spot, or about an opening.
  if (distance_m == 0) throw InputError(where + ": a way of no length, expected duration_s");
  if (!segment.speed_m_s) throw InputError(where + ": no timing, expected speed_m_s or duration_s");
  return distance_m / positive(*segment.speed_m_s, where + ".speed_m_s");
}

}  // namespace

ScriptedMotion::ScriptedMotion(const ScriptMotion& settings, const std::string& where)
    : first_{settings.start_m, unit(settings.start_orientation, where + ".start_orientation")} {
  last_ = first_;
  first_opening_ = settings.start_opening_deg.value_or(settings.start_opening_m.value_or(0));
  last_opening_ = first_opening_;
  for (std::size_t i = 0; i < settings.segments.size(); ++i) {
    const MotionSegment& segment = settings.segments[i];
    const std::string here = where + ".segments." + std::to_string(i);
    Piece piece{duration_s_,    0,
                last_,          last_,
                last_opening_,  segment.openTo().value_or(last_opening_),
                segment.timing, segment.ramp_fraction};
    if (segment.move_to_m) piece.to.position_m = *segment.move_to_m;
    if (segment.rotate_to) piece.to.orientation = unit(*segment.rotate_to, here + ".rotate_to");
    // q and -q are one rotation; the nearer one makes the way the shorter arc and the output continuous.
    if (piece.from.orientation.dot(piece.to.orientation) < 0) piece.to.orientation.coeffs() *= -1;
    if (segment.timing == Timing::trapezoidal && !(segment.ramp_fraction > 0 && segment.ramp_fraction <= 0.5))
      throw InputError(here + ".ramp_fraction: expected a value above 0, at most 0.5");
    const double distance_m = (piece.to.position_m - piece.from.position_m).norm();
    piece.duration_s =
        segment.hold_s ? holdDuration_s(segment, here) : moveDuration_s(segment, distance_m, here);
    duration_s_ += piece.duration_s;
    last_ = piece.to;
    last_opening_ = piece.opening_to;
    pieces_.push_back(piece);
  }
}

const ScriptedMotion::Piece* ScriptedMotion::pieceAt(double time_s, double& way) const {
  if (pieces_.empty() || time_s >= duration_s_ || time_s <= 0) return nullptr;
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), time_s,
                                      [](double time, const Piece& piece) { return time < piece.start_s; });
  const Piece& piece = *(after - 1);
  way = wayCovered(piece.timing, piece.ramp_fraction, (time_s - piece.start_s) / piece.duration_s);
  return &piece;
}

Pose ScriptedMotion::poseAt(double time_s) const {
  double way = 0;
  const Piece* piece = pieceAt(time_s, way);
  if (!piece) return pieces_.empty() || time_s >= duration_s_ ? last_ : first_;
  return {(1 - way) * piece->from.position_m + way * piece->to.position_m,
          slerp(piece->from.orientation, way, piece->to.orientation)};
}

double ScriptedMotion::openingAt(double time_s) const {
  double way = 0;
  const Piece* piece = pieceAt(time_s, way);
  if (!piece) return pieces_.empty() || time_s >= duration_s_ ? last_opening_ : first_opening_;
  return (1 - way) * piece->opening_from + way * piece->opening_to;
}

}  // namespace fissure
