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

/// The prescribed motion of a tool: its pose, and a clamp's opening, as functions of scenario time.
class Motion {
 public:
  virtual ~Motion() = default;
  /// Pose in the scene frame at `time_s`; before 0 the first pose, after duration_s() the last one.
  virtual Pose poseAt(double time_s) const = 0;
  /// Opening of a clamp at `time_s`, metres or, for hinged jaws, degrees, constant outside 0..duration_s()
  /// like the pose; 0 for tools that do not open.
  virtual double openingAt(double) const { return 0; }
  virtual double duration_s() const = 0;
  /// Scalars for the result's summary, such as the number of gaps in a replay; empty for scripts.
  virtual Summary summary() const { return {}; }
  /// Oddities in its log, one line each with file and line number; empty for scripts.
  virtual std::vector<std::string> notes() const { return {}; }
};

/// Largest speed and acceleration of the tool's origin in a run of `steps` steps of length `step_s`.
MotionPeaks peaksOf(const Motion& motion, double step_s, std::int64_t steps);

/// Builds the motion of a tool. `directory`: the folder of relative log files; `files`: the cache through
/// which they are read. Throws InputError, with file and line where known, for a log that is missing, empty,
/// binary or malformed, lacks a named column or has no usable row, and, with `tools.NAME.motion: ...`, for
/// settings that do not determine a motion.
std::unique_ptr<Motion> makeMotion(const ToolSettings& tool, const std::filesystem::path& directory,
                                   const LogFiles& files = LogFiles());

}  // namespace fissure
