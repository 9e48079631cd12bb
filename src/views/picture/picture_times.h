#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// A selection of the stored times; without any member set, all of them.
struct TimeSelection {
  std::optional<double> from_s, to_s;  ///< range of times, bounds included
  std::optional<double> every_s;       ///< in that range, the first stored time after each multiple of this
  std::vector<double> at_s;            ///< instead of a range: the stored time nearest to each of these
};

/// The selected times among `stored_s` (ascending, at least one), ascending, each once. Throws InputError
/// when none is selected, or when no stored time is near one of at_s.
std::vector<double> selectTimes(const std::vector<double>& stored_s, const TimeSelection& selection);

/// [picture] number of frames that show it in a video. Each frame shows the last picture that is not later
/// than the frame's time; the video starts with the first picture, and the last one is shown at least once.
/// Throws InputError for more than 100,000 frames.
std::vector<std::size_t> timesShown(const std::vector<double>& times_s, double frames_per_s,
                                    double slow_motion);

/// Texts of times in seconds, for file names: they sort like the times, and are different for times that
/// differ by a nanosecond or more.
class TimeTexts {
 public:
  explicit TimeTexts(const std::vector<double>& times_s);
  /// "0.050s".
  std::string of(double time_s) const;

 private:
  std::string text(double time_s, int decimals) const;

  int width_ = 0;
  int decimals_ = 3;
};

}  // namespace fissure
