#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fissure {

/// How far two results may differ in the quantities that it names: |A - B| <= absolute + relative * max |B|,
/// everywhere, at least after A was moved by at most time_shift_s.
struct ToleranceRule {
  std::string quantity;        ///< a pattern: "force*", "summary/max_force_N", "*"
  std::string pipeline = "*";  ///< a pattern for names of pipeline entries
  double absolute = 0;         ///< in the quantity's unit, >= 0
  double relative = 0;         ///< of the largest value of B, >= 0
  double time_shift_s = 0;     ///< >= 0
  bool ignore = false;         ///< may differ in any way, and may be missing
};

/// What a tolerance file says. The last rule that fits counts; nothing may differ where none does.
struct Tolerances {
  int format = 1;
  std::vector<ToleranceRule> tolerances;

  ToleranceRule of(const std::string& quantity, const std::string& pipeline) const;
};

/// Whether `name` fits a pattern in which * stands for any characters and ? for one.
bool fitsPattern(const std::string& name, const std::string& pattern);

/// Reads a tolerance file, as strictly as a scenario. Throws InputError with file and line.
Tolerances loadTolerances(const std::filesystem::path& file);

}  // namespace fissure
