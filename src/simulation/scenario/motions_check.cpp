#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "scenario/checker.h"

namespace fissure {

namespace {

/// One segment that starts at `from`.
void checkSegment(Checker check, const MotionSegment& segment, const Vec3& from) {
  const bool moves = segment.move_to_m || segment.rotate_to || segment.openTo();
  if (segment.hold_s) {
    check.require(!moves, "", "holds and moves, expected hold_s alone or without it a movement");
    check.require(!segment.speed_m_s && !segment.duration_s, "",
                  "gives hold_s and a speed or duration, expected hold_s alone");
    return;
  }
  check.require(moves, "", "does nothing, expected hold_s, move_to_m, rotate_to or, of a clamp, an opening");
  check.require(segment.speed_m_s.has_value() != segment.duration_s.has_value(), "",
                "expected exactly one of speed_m_s and duration_s");
  const bool on_the_spot = !segment.move_to_m || *segment.move_to_m == from;
  check.require(!moves || !segment.speed_m_s || !on_the_spot, "speed_m_s",
                "is given for a way of no length, expected duration_s");
}

void checkPath(Checker check, const ScriptMotion& motion, const std::optional<ClampSettings>& clamp) {
  Vec3 from = motion.start_m;
  for (std::size_t i = 0; i < motion.segments.size(); ++i) {
    checkSegment(check.in("segments." + std::to_string(i)), motion.segments[i], from);
    from = motion.segments[i].move_to_m.value_or(from);
  }
  checkOpenings(check, motion, clamp);
}

/// Determinant of the signed permutation that `axes` says, 0 if it is none.
int handedness(const std::array<std::string, 3>& axes) {
  Mat3 rows = Mat3::Zero();
  for (int i = 0; i < 3; ++i) {
    const std::string& axis = axes[static_cast<std::size_t>(i)];
    const bool negative = !axis.empty() && axis[0] == '-';
    const std::string letter = axis.substr(negative ? 1 : 0);
    if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z') return 0;
    rows(i, letter[0] - 'x') = negative ? -1 : 1;
  }
  return static_cast<int>(std::lround(rows.determinant()));
}

void checkColumns(Checker check, const ReplayMotion& motion) {
  std::multiset<std::string> columns(motion.position_columns.begin(), motion.position_columns.end());
  if (motion.quaternion_columns)
    columns.insert(motion.quaternion_columns->begin(), motion.quaternion_columns->end());
  if (motion.time_column) columns.insert(*motion.time_column);
  if (motion.frame_column) columns.insert(*motion.frame_column);
  for (const std::string& column : columns) {
    if (column.empty()) return check.fail("", "has a column without a name, expected names of columns");
    if (columns.count(column) > 1) {
      return check.fail("",
                        fmt::format("uses column \"{}\" twice, expected a column for each value", column));
    }
  }
}

void checkPath(Checker check, const ReplayMotion& motion, const std::optional<ClampSettings>& clamp) {
  check.require(!motion.file.empty(), "file", "is empty, expected the name of a log");
  check.require(motion.time_column.has_value() != motion.rate_hz.has_value(), "",
                motion.layout == LogLayout::rows
                    ? "expected exactly one of time_column and rate_hz"
                    : "expected rate_hz, which says when the samples of layout axes were");
  check.require(!motion.time_unit || motion.time_column, "time_unit",
                "is given without time_column, expected that column's name too");
  check.require(!motion.frame_column || !motion.time_column, "frame_column",
                "is given beside time_column, expected rate_hz with it");
  checkColumns(check, motion);
  Checker mapping = check.in("mapping");
  const int hand = handedness(motion.mapping.sceneAxes());
  mapping.require(hand != 0, "axes", "expected x, y and z, each once and perhaps with a minus: [x, -z, y]");
  mapping.require(hand >= 0, "axes", "is left-handed, expected a right-handed frame (turn one sign)");
  // NaN, of values that are bad anyway, passes.
  check.require(!motion.end_s || !(*motion.end_s <= motion.start_s), "end_s",
                "expected a time after start_s");
  checkOpenings(check, motion, clamp);
}

}  // namespace

void checkMotion(Checker check, const ToolMotion& motion, const std::optional<ClampSettings>& clamp) {
  std::visit([&](const auto& alternative) { checkPath(check, alternative, clamp); }, motion);
}

}  // namespace fissure
