#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "process/progress_display.h"
#include "scenario/load.h"
#include "sweep/sweep_plan.h"
#include "sweep/sweep_state.h"

namespace fissure {

/// A sweep over a list of points, as studies make them.
struct StudySweep {
  std::filesystem::path folder;  ///< its file is `<folder>.yaml`
  std::string name;
  std::filesystem::path base;  ///< scenario file
  std::string pipeline;
  std::optional<double> time_s;  ///< limits of each simulation
  std::optional<double> memory_mib;
  std::vector<std::vector<Override>> points;  ///< at least one; the same paths in all
};

/// Writes the file of the sweep, by which `fissure sweep` would run it, plans it and puts the plan into its
/// folder. Records of points that were in it before stay. Throws InputError for points that are not valid.
void putSweep(const StudySweep& sweep);

/// The points of a planned sweep that nobody has tried yet.
std::size_t untriedIn(const std::filesystem::path& folder);

/// Runs those; simulations that have failed are not tried again. Throws Interrupted after a request to stop,
/// with all finished work stored, and as SweepSession does.
void runUntried(const std::filesystem::path& folder, int slots, const std::string& command_line,
                ProgressDisplay& display);

/// What became of a point.
struct StudyRun {
  RunStatus status;              ///< `missing`: not tried
  std::filesystem::path result;  ///< empty where none is kept
  double wall_s = 0;
};

/// What became of all points of a planned sweep, in their order.
std::vector<StudyRun> runsOf(const std::filesystem::path& folder);

}  // namespace fissure
