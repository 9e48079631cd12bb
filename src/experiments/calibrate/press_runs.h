#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/progress_display.h"

namespace fissure {

/// Where the simulations for a fit are kept.
struct PressOutput {
  /// Folder of the results, created where it is missing.
  std::string folder = "out";
  std::string command_line;  ///< in the form that results record
};

/// The results that a fit uses.
struct PressRuns {
  /// The results among `names`, and a file with one run for each simulation.
  std::vector<std::string> results;
  /// One line for each simulation without a result: its name and the reason.
  std::vector<std::string> failures;
};

/// Whether the name is that of a scenario or a sweep (.yaml, .yml), which must be simulated, and not of a
/// result.
bool isToSimulate(const std::filesystem::path& file);

/// Simulates the files among `names` that end in .yaml or .yml; the others are results. Scenarios, and sweeps
/// that keep results, are simulated as by `fissure run` and `fissure sweep`. Each pipeline entry of a
/// scenario gets a result file of its own, `<folder>/<scenario>.h5` or, with several entries,
/// `<folder>/<scenario>-<entry>.h5`; a sweep gets the folder `<folder>/<its name>`. Runs of the same scenario
/// and inputs that are finished there are not repeated, so that stopped or killed work is continued.
///
/// Throws InputError, before anything is simulated, for a file that cannot be simulated or whose result could
/// not be fitted, and where the result of another scenario has the same path. Throws RunError when writing
/// fails, and Interrupted after a request to stop, with all finished work stored.
PressRuns pressRuns(const std::vector<std::string>& names, const PressOutput& output,
                    ProgressDisplay& display);

}  // namespace fissure
