#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "base/motion_peaks.h"
#include "base/record.h"
#include "scenario/tools.h"
#include "text/log_text.h"

namespace fissure {

/// A tool's pose, and a clamp's opening, as functions of scenario time.
class Motion {
 public:
  virtual ~Motion() = default;
  /// Pose at `time_s`; before 0 the first pose, after duration() the last one.
  virtual Pose poseAt(double time_s) const = 0;
  /// Of a clamp's jaws, metres or degrees; 0 for tools that do not open. The same times as of poseAt.
  virtual double openingAt(double) const { return 0; }
  virtual double duration_s() const = 0;
  /// Scalars for the result's summary, e.g. what a replay held, skipped or found (empty for scripts).
  virtual Summary summary() const { return {}; }
  /// What is odd about its log, a line each, with file and line (empty for scripts).
  virtual std::vector<std::string> notes() const { return {}; }
};

/// Largest speed and acceleration of the tool's origin in a run of `steps` steps of `step_s`.
MotionPeaks peaksOf(const Motion& motion, double step_s, std::int64_t steps);

/// Builds the motion a tool names. `directory`: where relative log files start; `files`: reads them. Throws
/// InputError, with file and line where there is one, for a log that is missing, empty, binary, malformed,
/// lacks a named column or has no usable row, and for settings that name no path (`tools.NAME.motion: ...`).
std::unique_ptr<Motion> makeMotion(const ToolSettings& tool, const std::filesystem::path& directory,
                                   const LogFiles& files = LogFiles());

}  // namespace fissure
