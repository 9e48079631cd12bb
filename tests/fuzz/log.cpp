#include <cmath>
#include <set>

#include "motion/device_log.h"
#include "motion/replayed_motion.h"
#include "scenario/motions.h"
#include "target.h"
#include "text/delimited_text.h"

namespace fissure::fuzz {

namespace {

constexpr const char* where = "tools.tool.motion";

void requireLog(const DeviceLog& log, const ReplayMotion& settings) {
  const std::size_t samples = log.times_s.size();
  require(samples > 0 && log.positions_m.size() == samples && log.rows.size() == samples &&
              log.lines.size() == samples,
          "every sample has a time, a position, a row and a line");
  require(log.orientations.size() == (settings.quaternion_columns ? samples : 0),
          "every sample has an orientation");
  for (std::size_t i = 0; i < samples; ++i) {
    require(std::isfinite(log.times_s[i]) && log.positions_m[i].allFinite(), "samples are finite");
    require(i == 0 || log.times_s[i] > log.times_s[i - 1], "times increase");
    require(i == 0 || log.lines[i] > log.lines[i - 1] || settings.layout == LogLayout::axes,
            "lines increase");
  }
  for (const Quat& orientation : log.orientations)
    require(std::abs(orientation.norm() - 1) < 1e-9, "orientations have length 1");
}

void play(const ReplayMotion& settings, const std::filesystem::path& file) {
  const LogFiles files;
  bool has_log = accepts(file, Refusal::file,
                         [&] { requireLog(readDeviceLog(settings, file, where, files), settings); });
  if (!has_log) return;
  try {
    const ReplayedMotion motion(settings, scratch(), where, files);
    require(motion.duration_s() >= 0 && std::isfinite(motion.duration_s()), "a replay ends");
    for (const double share : {-0.1, 0.0, 0.3, 0.5, 0.99, 1.0, 1.1}) {
      const Pose pose = motion.poseAt(share * motion.duration_s());
      require(pose.position_m.allFinite() && std::abs(pose.orientation.norm() - 1) < 1e-9,
              "poses are finite");
    }
    for (const std::string& note : motion.notes()) require(isOneLine(note), "a note is one line: " + note);
    motion.summary();
  } catch (const InputError& error) {
    require(isOneLine(error.what()), std::string("an error is one line: ") + error.what());
  }
}

/// The names of the columns, where each is there once and there are enough of them.
std::vector<std::string> columnsOf(const std::filesystem::path& file) {
  std::vector<std::string> names;
  accepts(file, Refusal::file, [&] {
    DelimitedText text(file);
    names = text.names();
    while (text.next()) require(text.line() > text.headerLine(), "rows stand below the header");
  });
  return names;
}

}  // namespace

/// Any text is played in every layout: columns mean what they can by their place.
void takeLog(const std::string& bytes) {
  const std::filesystem::path file = put("fuzzed.csv", bytes);
  ReplayMotion axes;
  axes.file = "fuzzed.csv";
  axes.layout = LogLayout::axes;
  axes.rate_hz = 1000;
  play(axes, file);
  const std::vector<std::string> names = columnsOf(file);
  if (names.size() < 4) return;
  ReplayMotion timed;
  timed.file = axes.file;
  timed.time_column = names[0];
  timed.position_columns = {names[1], names[2], names[3]};
  timed.interpolation = Interpolation::monotone_cubic;
  play(timed, file);
  ReplayMotion counted = timed;
  counted.time_column.reset();
  counted.frame_column = names[0];
  counted.rate_hz = 60;
  counted.position_unit = LengthUnit::mm;
  if (names.size() >= 8) counted.quaternion_columns = {names[4], names[5], names[6], names[7]};
  play(counted, file);
  ReplayMotion filtered = counted;
  filtered.frame_column.reset();
  filtered.where = RowFilter{names.back(), "1"};
  filtered.start_s = 0.01;
  filtered.mapping.frame = DeviceFrame::chai3d;
  play(filtered, file);
}

}  // namespace fissure::fuzz
