#include "motion/replayed_motion.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/error.h"
#include "base/rotation.h"
#include "motion/monotone_cubic.h"
#include "text/scalars.h"
#include "text/units.h"

namespace fissure {
namespace {

/// Times are sums and quotients of decimal fractions. Two of them that are meant to be equal may differ by
/// this much, far less than any device's clock resolves.
constexpr double time_slack_s = 1e-9;

/// The same for lengths: 0.03 - 0.01 is more than 0.02 to a computer.
constexpr double jump_slack_m = 1e-12;

/// The way of the device to a sample from the one before it.
double stepTo_m(const DeviceLog& log, std::size_t sample) {
  return (log.positions_m[sample] - log.positions_m[sample - 1]).norm();
}

}  // namespace

ReplayedMotion::ReplayedMotion(const ReplayMotion& settings, const std::filesystem::path& directory,
                               const std::string& where, const LogFiles& files)
    : max_gap_s_(settings.max_gap_s) {
  const DeviceToScene mapping(settings.mapping, where + ".mapping");
  const std::filesystem::path file = directory / settings.file;
  DeviceLog log = readDeviceLog(settings, file, where, files);
  times_s_ = std::move(log.times_s);
  setWindow(settings, file.string(), where);
  if (settings.opening) opening_.emplace(*settings.opening, settings.mapping, mapping);
  count(log, settings);
  noteSteps(log, settings, file.string());
  map(log, mapping);
  if (settings.interpolation == Interpolation::monotone_cubic) computeSlopes();
}

void ReplayedMotion::setWindow(const ReplayMotion& settings, const std::string& file,
                               const std::string& where) {
  const double last_s = times_s_.back();
  const double end_s = settings.end_s.value_or(last_s);
  const auto beyond = [&](const std::string& setting, double value_s) {
    return InputError(inFile(file), fmt::format("ends at {} s of log time, but {}{} is {}",
                                                formatReal(last_s), where, setting, formatReal(value_s)));
  };
  if (!(settings.start_s >= 0)) throw InputError(where + ".start_s: expected a value of at least 0");
  if (settings.start_s > last_s + time_slack_s) throw beyond(".start_s", settings.start_s);
  // An end a little late is held like any short gap; a later one is a mistake.
  if (end_s > last_s + max_gap_s_ + time_slack_s) throw beyond(".end_s", end_s);
  if (settings.end_s && !(end_s > settings.start_s))
    throw InputError(where + ".end_s: expected a value above start_s");
  duration_s_ = std::max(0.0, end_s - settings.start_s);
  for (double& time_s : times_s_) time_s -= settings.start_s;
}

bool ReplayedMotion::isPlayed(double time_s) const {
  return time_s >= -time_slack_s && time_s <= duration_s_ + time_slack_s;
}

bool ReplayedMotion::isStepPlayed(std::size_t to) const {
  return times_s_[to] > time_slack_s && times_s_[to - 1] < duration_s_ - time_slack_s;
}

void ReplayedMotion::count(const DeviceLog& log, const ReplayMotion& settings) {
  const bool from_start = isPlayed(times_s_.front()), to_end = isPlayed(times_s_.back());
  std::size_t first_row = 0, last_row = std::numeric_limits<std::size_t>::max();
  long long samples = 0, held = 0, gaps = 0, saturated = 0;
  for (std::size_t i = 0; i < times_s_.size(); ++i) {
    if (isPlayed(times_s_[i])) {
      ++samples;
      if (opening_ && opening_->saturates(log.positions_m[i])) ++saturated;
    }
    // Rows outside the samples that bracket the window are not replayed; at the log's own ends there is no
    // such sample.
    if (!from_start && times_s_[i] <= 0) first_row = log.rows[i];
    if (!to_end && times_s_[i] >= duration_s_) last_row = std::min(last_row, log.rows[i]);
    if (i == 0 || !isStepPlayed(i)) continue;
    const bool turned =
        !log.orientations.empty() && log.orientations[i].coeffs() != log.orientations[i - 1].coeffs();
    if (log.positions_m[i] == log.positions_m[i - 1] && !turned) ++held;
    if (isGap(i - 1)) ++gaps;
  }
  const auto replayed = [&](const std::vector<std::size_t>& rows) -> long long {
    return std::count_if(rows.begin(), rows.end(),
                         [&](std::size_t row) { return row >= first_row && row <= last_row; });
  };
  summary_ = {{"replay_samples", samples},
              {"replay_held_samples", held},
              {"replay_gaps", gaps},
              {"replay_dropped_rows", replayed(log.dropped_rows)},
              {"replay_rows_beyond_reason", replayed(log.beyond_reason)},
              {"replay_repeated_rows", replayed(log.repeated_rows)}};
  if (settings.where) summary_.push_back({"replay_filtered_rows", replayed(log.filtered_rows)});
  if (opening_) summary_.push_back({"replay_saturated_openings", saturated});
  if (log.beyond_reason.empty()) return;
  notes_.push_back(fmt::format("{}: the first of {} in the log, rows without a pose", log.first_beyond_reason,
                               log.beyond_reason.size()));
}

void ReplayedMotion::noteSteps(const DeviceLog& log, const ReplayMotion& settings, const std::string& file) {
  long long jumps = 0, fast = 0;
  std::size_t first_jump = 0, first_fast = 0;
  for (std::size_t i = 1; i < times_s_.size(); ++i) {
    if (!isStepPlayed(i)) continue;
    const double step_m = stepTo_m(log, i);
    const double time_s = times_s_[i] - times_s_[i - 1];
    if (step_m > settings.jump_m + jump_slack_m && ++jumps == 1) first_jump = i;
    if (step_m > settings.jump_speed_m_s * (time_s + time_slack_s) && ++fast == 1) first_fast = i;
  }
  summary_.push_back({"replay_jumps", jumps});
  summary_.push_back({"replay_fast_steps", fast});
  const auto note = [&](long long steps, std::size_t first, const std::string& limit) {
    if (steps == 0) return;
    const double step_m = stepTo_m(log, first), time_s = times_s_[first] - times_s_[first - 1];
    const bool rows = settings.layout == LogLayout::rows;
    const std::string at = rows ? inFile(file, log.lines[first]).beginning()
                                : fmt::format("{}sample {}, ", inFile(file).beginning(), log.rows[first]);
    notes_.push_back(fmt::format("{}a step of {} in {}, {} m/s, is {}: the first of {}, played as it is", at,
                                 withUnit(step_m, "m"), withUnit(time_s, "s"), fourDigits(step_m / time_s),
                                 limit, steps));
  };
  note(jumps, first_jump, "longer than jump_m, " + withUnit(settings.jump_m, "m"));
  note(fast, first_fast,
       fmt::format("faster than jump_speed_m_s, {} m/s", fourDigits(settings.jump_speed_m_s)));
}

void ReplayedMotion::map(const DeviceLog& log, const DeviceToScene& mapping) {
  positions_m_.reserve(log.positions_m.size());
  for (const Vec3& position : log.positions_m) positions_m_.push_back(mapping.position_m(position));
  if (log.orientations.empty()) orientations_ = {mapping.mount()};
  for (const Quat& device : log.orientations) {
    Quat orientation = mapping.orientation(device);
    // q and -q are one rotation: a device may write either from row to row.
    if (!orientations_.empty() && orientations_.back().dot(orientation) < 0) orientation.coeffs() *= -1;
    orientations_.push_back(orientation);
  }
}

void ReplayedMotion::computeSlopes() {
  // Each run between two gaps by itself: what lies behind a gap must not bend the motion before it.
  slopes_m_s_.reserve(times_s_.size());
  for (std::size_t first = 0; first < times_s_.size();) {
    std::size_t last = first;
    while (last + 1 < times_s_.size() && !isGap(last)) ++last;
    const std::size_t length = last - first + 1;
    const std::vector<Vec3> slopes = monotoneSlopes(std::span(times_s_).subspan(first, length),
                                                    std::span(positions_m_).subspan(first, length));
    slopes_m_s_.insert(slopes_m_s_.end(), slopes.begin(), slopes.end());
    first = last + 1;
  }
}

bool ReplayedMotion::isGap(std::size_t before) const {
  return times_s_[before + 1] - times_s_[before] > max_gap_s_ + time_slack_s;
}

Pose ReplayedMotion::poseAt(double time_s) const {
  Pose pose = handAt(time_s);
  if (opening_) pose.position_m = opening_->inPlane(pose.position_m);
  return pose;
}

double ReplayedMotion::openingAt(double time_s) const {
  return opening_ ? opening_->opening(handAt(time_s).position_m) : 0;
}

Pose ReplayedMotion::handAt(double time_s) const {
  const double t = std::clamp(time_s, 0.0, duration_s_);
  const auto sample = [&](std::size_t i) {
    return Pose{positions_m_[i], orientations_[orientations_.size() == 1 ? 0 : i]};
  };
  const auto after = std::upper_bound(times_s_.begin(), times_s_.end(), t);
  if (after == times_s_.begin()) return sample(0);
  const auto i = static_cast<std::size_t>(after - times_s_.begin()) - 1;
  if (after == times_s_.end()) return sample(i);
  if (isGap(i)) return sample(t > times_s_[i + 1] - time_slack_s ? i + 1 : i);

  const double length_s = times_s_[i + 1] - times_s_[i];
  const double u = (t - times_s_[i]) / length_s;
  Pose pose = sample(i);
  pose.orientation = slerp(pose.orientation, u, sample(i + 1).orientation);
  pose.position_m = slopes_m_s_.empty() ? (1 - u) * positions_m_[i] + u * positions_m_[i + 1]
                                        : hermite(positions_m_[i], positions_m_[i + 1], slopes_m_s_[i],
                                                  slopes_m_s_[i + 1], length_s, u);
  return pose;
}

}  // namespace fissure
