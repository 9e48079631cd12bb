#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fit/match_by.h"
#include "scenario/key_tree.h"
#include "sweep/sweep_axes.h"
#include "task/curves.h"

namespace fissure {

enum class SweepDesign { grid, random, latin_hypercube, sobol };

/// Limits of each simulation of a sweep.
struct SweepLimits {
  std::optional<double> time_s;
  std::optional<double> memory_mib;
};

/// A measured curve with which the forces of runs are compared.
struct SweepFit {
  std::string curve;
  std::optional<std::string> columns;
  MatchBy match = MatchBy::depth;
  std::optional<std::string> law;
  bool free_offset = true;
};

/// The output of a simulation that is kept beside its row of the table.
enum class SweepKeep { metrics, results, series };

/// The contents of a sweep file.
struct SweepSettings {
  int format = 1;
  std::string name;
  std::string description;
  std::string base;
  std::vector<std::string> pipelines;
  std::vector<AxisGroup> axes;
  std::vector<std::vector<SweepCondition>> exclude;
  SweepDesign design = SweepDesign::grid;
  std::optional<int> count;
  std::optional<int> seed;
  int repeats = 1;
  SweepKeep keep = SweepKeep::metrics;
  std::optional<SweepCurves> curves;
  std::optional<SweepFit> fit;
  SweepLimits limits;
  std::string source;               ///< text of the file, verbatim
  std::filesystem::path directory;  ///< folder of the sweep file
};

/// The names that sweep files can choose, in the order of SweepDesign, MatchBy and SweepKeep.
const std::vector<CatalogEntry>& sweepDesigns();
const std::vector<CatalogEntry>& curveMatches();
const std::vector<CatalogEntry>& sweepKeeps();

/// The name of a design in sweep files.
std::string designName(SweepDesign design);

/// A value in canonical form, so that equal numbers have equal texts.
std::string plainValue(const std::string& yaml);

/// Whether a YAML file has axes, and so is a sweep and no scenario. Throws InputError if it cannot be read.
bool isSweepFile(const std::filesystem::path& file);

/// Reads a sweep file as strictly as a scenario. Throws InputError with file and line, also for an empty
/// range, equal values of an axis, two axes on a path, zipped axes of unequal lengths, a condition without an
/// axis.
SweepSettings loadSweep(const std::filesystem::path& file);

/// The keys of sweep files.
KeyNode sweepKeys();

template <class Io>
void describe(Io& io, SweepFit& fit) {
  io.field(
      "curve", fit.curve,
      Key("File of one measured curve, as `fissure fit` reads it, relative to the folder of the sweep file.")
          .required());
  io.field("columns", fit.columns,
           Key("Which columns mean what, as `--columns` of `fissure fit`.").otherwise("by their names"));
  io.field("match", fit.match,
           Key("Where measured points and those of a run meet; depth needs the curve `indentation`.")
               .oneOf(curveMatches()));
  io.field("law", fit.law,
           Key("Name of the scenario's force law whose force is compared.").otherwise("the first law"));
  io.field("free_offset", fit.free_offset,
           Key("Whether the offset F0 of the force is the one of the least misfit, else it is 0."));
}

template <class Io>
void describe(Io& io, SweepLimits& limits) {
  io.field("time_s", limits.time_s,
           Key("Wall-clock time that a simulation may take.")
               .above(0)
               .otherwise("what the scenario's pipelines say"));
  io.field("memory_mb", limits.memory_mib,
           Key("Memory for data that a worker may hold.").above(0).otherwise("no limit"));
}

template <class Io>
void describe(Io& io, SweepSettings& sweep) {
  io.field("format", sweep.format, Key("Format of the file.").count(1, 1).required());
  io.field("name", sweep.name,
           Key("Name of the sweep and of its folder: 1 to 64 letters, digits, '_' and '-'.")
               .itemName()
               .required());
  io.field("description", sweep.description, Key("One line that says what the sweep is for.").mayBeEmpty());
  io.field("base", sweep.base,
           Key("Scenario file whose places the axes change, relative to the folder of the sweep file.")
               .required());
  io.field("pipelines", sweep.pipelines, Key("Names of the scenario's runs that are made; empty for all."));
  io.field("axes", sweep.axes,
           Key("Places of the scenario and the values that they take.").items(1, any_number).required());
  io.field("exclude", sweep.exclude,
           Key("Points that are left out: those for which all conditions of one of these lists hold."));
  io.field("design", sweep.design, Key("Which points of the axes are run.").oneOf(sweepDesigns()));
  const bool sampled = sweep.design != SweepDesign::grid;
  const char* const of_sampled = "design random, latin_hypercube or sobol";
  io.field("count", sweep.count,
           Key("Number of points.")
               .count(1)
               .required(sampled)
               .otherwise("required of these designs")
               .onlyIf(sampled, of_sampled));
  io.field("seed", sweep.seed,
           Key("Seed of the random numbers; the same seed gives the same points.")
               .count(0)
               .required(sampled)
               .otherwise("required of these designs")
               .onlyIf(sampled, of_sampled));
  io.field(
      "repeats", sweep.repeats,
      Key("How often every simulation is run: for its timings, and to see that all else comes out equal.")
          .count(1));
  io.field("keep", sweep.keep,
           Key("What is kept of each simulation beside its row of the table.").oneOf(sweepKeeps()));
  io.field("curves", sweep.curves,
           Key("Quantities that are kept over a time that all runs share.").otherwise("no curves"));
  io.field("fit", sweep.fit,
           Key("A measured curve that the force of each run is compared with; the table then has `misfit_N`.")
               .otherwise("no comparison"));
  io.field("limits", sweep.limits, Key("What each simulation may take."));
}

}  // namespace fissure
