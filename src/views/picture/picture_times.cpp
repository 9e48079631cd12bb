#include "picture/picture_times.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/steps.h"

namespace fissure {

namespace {

constexpr double slack_s = 1e-9;  // what rounding may add

std::string rangeText(const std::vector<double>& stored_s) {
  return fmt::format("expected times from {:g} to {:g} s", stored_s.front(), stored_s.back());
}

double nearest(const std::vector<double>& stored_s, double time_s) {
  return *std::min_element(stored_s.begin(), stored_s.end(),
                           [&](double a, double b) { return std::abs(a - time_s) < std::abs(b - time_s); });
}

std::vector<double> nearestTimes(const std::vector<double>& stored_s, const std::vector<double>& at_s) {
  double widest_s = 0;
  for (std::size_t i = 1; i < stored_s.size(); ++i)
    widest_s = std::max(widest_s, stored_s[i] - stored_s[i - 1]);
  std::set<double> chosen;
  for (const double time_s : at_s) {
    const double found_s = nearest(stored_s, time_s);
    if (!(std::abs(found_s - time_s) <= widest_s / 2 + slack_s))
      throw InputError(
          fmt::format("--at: there is no snapshot near {:g} s, {}", time_s, rangeText(stored_s)));
    chosen.insert(found_s);
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace

std::vector<double> selectTimes(const std::vector<double>& stored_s, const TimeSelection& selection) {
  if (!selection.at_s.empty()) return nearestTimes(stored_s, selection.at_s);
  std::vector<double> chosen;
  double last_multiple = -1;
  for (const double time_s : stored_s) {
    if (selection.from_s && time_s < *selection.from_s - slack_s) continue;
    if (selection.to_s && time_s > *selection.to_s + slack_s) continue;
    if (selection.every_s) {
      const double multiple = intervalsIn(time_s, *selection.every_s);
      if (!chosen.empty() && multiple <= last_multiple) continue;
      last_multiple = multiple;
    }
    chosen.push_back(time_s);
  }
  if (chosen.empty())
    throw InputError("--from, --to: there is no snapshot in this range, " + rangeText(stored_s));
  return chosen;
}

std::vector<std::size_t> timesShown(const std::vector<double>& times_s, double frames_per_s,
                                    double slow_motion) {
  constexpr double most_frames = 100000;
  const double rate = frames_per_s * slow_motion;  // frames a simulated second
  const double frames = std::floor((times_s.back() - times_s.front()) * rate + 1e-6) + 1;
  if (!(frames <= most_frames))
    throw InputError(
        fmt::format("--video: would have {:g} frames, expected at most 100000: a shorter range, fewer frames "
                    "a second, less slow motion",
                    frames));
  std::vector<std::size_t> shown(times_s.size(), 0);
  std::size_t current = 0;
  for (std::size_t frame = 0; frame < static_cast<std::size_t>(frames); ++frame) {
    const double time_s = times_s.front() + static_cast<double>(frame) / rate;
    while (current + 1 < times_s.size() && times_s[current + 1] <= time_s + 1e-6 / rate) ++current;
    ++shown[current];
  }
  shown.back() = std::max<std::size_t>(shown.back(), 1);
  return shown;
}

TimeTexts::TimeTexts(const std::vector<double>& times_s) {
  constexpr int most_decimals = 9;
  const auto distinct = [&] {
    std::set<std::string> texts;
    for (const double time_s : times_s) texts.insert(text(time_s, decimals_));
    return texts.size() == std::set<double>(times_s.begin(), times_s.end()).size();
  };
  while (decimals_ < most_decimals && !distinct()) ++decimals_;
  for (const double time_s : times_s)
    width_ = std::max(width_, static_cast<int>(text(time_s, decimals_).size()));
}

std::string TimeTexts::text(double time_s, int decimals) const {
  return fmt::format("{:0{}.{}f}", time_s, width_, decimals);
}

std::string TimeTexts::of(double time_s) const {
  return text(time_s, decimals_) + "s";
}

}  // namespace fissure
