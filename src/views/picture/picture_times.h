#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// Which of the stored instants are wanted; nothing stated: all.
struct TimeSelection {
  std::optional<double> from_s, to_s;  ///< both included
  std::optional<double> every_s;       ///< of these, the first after each multiple of it
  std::vector<double> at_s;            ///< else the stored instant nearest to each of these
};

/// The wanted ones of `stored_s` (ascending, at least one), ascending and each once. Throws InputError when
/// there is none, or none near one of at_s.
std::vector<double> selectTimes(const std::vector<double>& stored_s, const TimeSelection& selection);

/// How often each of the pictures at these times is shown in a video that starts with the first: at each
/// frame's time the last one that is not later. The last one is shown at least once. Throws InputError for
/// more than 100,000 frames.
std::vector<std::size_t> timesShown(const std::vector<double>& times_s, double frames_per_s,
                                    double slow_motion);

/// Texts of times in seconds that sort as the times do and differ where these do, to the nanosecond.
class TimeTexts {
 public:
  explicit TimeTexts(const std::vector<double>& times_s);
  std::string of(double time_s) const;  ///< "0.050s"

 private:
  std::string text(double time_s, int decimals) const;

  int width_ = 0;
  int decimals_ = 3;
};

}  // namespace fissure
