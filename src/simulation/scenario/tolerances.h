#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/key.h"

namespace fissure {

struct KeyNode;

/// The allowed difference of two results in the quantities that match a pattern: |A - B| <= absolute +
/// relative * max |B| at all times, if necessary after A was shifted in time by at most time_shift_s.
struct ToleranceRule {
  std::string quantity;
  std::string pipeline = "*";
  double absolute = 0;
  double relative = 0;
  double time_shift_s = 0;
  bool ignore = false;
};

/// The contents of a tolerance file. The last matching rule counts; without one nothing may differ.
struct Tolerances {
  int format = 1;
  std::vector<ToleranceRule> tolerances;

  /// The rule for this quantity and pipeline.
  ToleranceRule of(const std::string& quantity, const std::string& pipeline) const;
};

template <class Io>
void describe(Io& io, ToleranceRule& rule) {
  io.field("quantity", rule.quantity,
           Key("Pattern for names of quantities, in which * stands for any characters and ? for one: "
               "'force*', summary/max_force_N, '*'.")
               .required());
  io.field("pipeline", rule.pipeline, Key("Pattern for names of runs."));
  io.field("absolute", rule.absolute,
           Key("Difference that is allowed everywhere.").unit("the unit of the quantity").atLeast(0));
  io.field("relative", rule.relative,
           Key("Difference that is allowed besides, over the largest value in B.").noUnit().atLeast(0));
  io.field("time_shift_s", rule.time_shift_s,
           Key("How much earlier or later A may be as a whole.").atLeast(0));
  io.field("ignore", rule.ignore, Key("Whether the quantity may differ in any way, and may be missing."));
}

template <class Io>
void describe(Io& io, Tolerances& tolerances) {
  io.field("format", tolerances.format, Key("Format of the file.").count(1, 1).required());
  io.field("tolerances", tolerances.tolerances,
           Key("What may differ: of several rules that fit a quantity and a run the last one counts, and "
               "without one nothing may differ.")
               .required());
}

/// Whether `name` matches a pattern in which * stands for any characters and ? for one.
bool fitsPattern(const std::string& name, const std::string& pattern);

/// Reads a tolerance file, as strictly as a scenario. Throws InputError with file and line.
Tolerances loadTolerances(const std::filesystem::path& file);

/// The keys of tolerance files.
KeyNode toleranceKeys();

}  // namespace fissure
