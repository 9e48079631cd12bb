#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fit/match_by.h"
#include "task/curves.h"

namespace fissure {

/// Numbers from `from` to `to`, both among them, evenly spaced or by equal factors.
struct AxisRange {
  double from = 0;
  double to = 0;
  int count = 0;  ///< of the grid; other designs take any number in between. >= 2
};

/// The values that one place of the scenario takes: exactly one of the three.
struct SweepAxis {
  std::string path;                                ///< of the scenario, as for `--set`
  std::optional<std::vector<std::string>> values;  ///< YAML of each
  std::optional<AxisRange> linear;
  std::optional<AxisRange> logarithmic;  ///< both ends > 0
  int line = 0;                          ///< of the file
};

/// Axes that go together: their values are taken side by side. An axis by itself is a group of one.
struct AxisGroup {
  std::vector<SweepAxis> axes;  ///< of equal length
};

/// A condition on the value of one axis: all that is given must hold.
struct SweepCondition {
  std::string path;  ///< of an axis
  std::optional<double> min, max;
  std::optional<std::vector<std::string>> values;  ///< YAML, one of them
};

enum class SweepDesign { grid, random, latin_hypercube, sobol };

/// What each simulation of a sweep may take.
struct SweepLimits {
  std::optional<double> time_s;      ///< wall clock; default: what the scenario's pipelines say
  std::optional<double> memory_mib;  ///< of data a worker may hold; the files call it memory_mb
};

/// A measured curve that the runs' forces are held against.
struct SweepFit {
  std::string curve;                   ///< file as `fissure fit` reads it, relative to the sweep's
  std::optional<std::string> columns;  ///< as --columns of `fissure fit`; default: by their names
  MatchBy match = MatchBy::depth;      ///< over the curve `indentation`, or over time
  std::optional<std::string> law;      ///< of the scenario; default: its first
  bool free_offset = true;             ///< F0 is the one of the least misfit, else 0
};

/// What is kept of each simulation beside its row of the table.
enum class SweepKeep { metrics, results };

/// What a sweep file says.
struct SweepSettings {
  int format = 1;
  std::string name;
  std::string description;
  std::string base;                    ///< scenario file, relative to the sweep's
  std::vector<std::string> pipelines;  ///< names of its entries; empty: all
  std::vector<AxisGroup> axes;
  std::vector<std::vector<SweepCondition>> exclude;  ///< points for which all conditions of one item hold
  SweepDesign design = SweepDesign::grid;
  std::optional<int> count;  ///< points of the other designs
  std::optional<int> seed;   ///< of the other designs
  int repeats = 1;           ///< of every simulation: for its timings, and to see that all else is equal
  SweepKeep keep = SweepKeep::metrics;
  std::optional<SweepCurves> curves;
  std::optional<SweepFit> fit;
  SweepLimits limits;
  std::string source;               ///< the file, verbatim
  std::filesystem::path directory;  ///< of the sweep file
};

/// As sweep files write it.
std::string designName(SweepDesign design);

/// A value in one way of writing: equal numbers have equal texts.
std::string plainValue(const std::string& yaml);

/// Reads a sweep file, as strictly as a scenario. Throws InputError with file and line: also for an empty
/// range, equal values of an axis, two axes on one path, zipped axes of different lengths, a condition on
/// what is no axis.
SweepSettings loadSweep(const std::filesystem::path& file);

}  // namespace fissure
