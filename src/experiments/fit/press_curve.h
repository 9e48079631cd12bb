#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fissure {

/// The reaction of one elastic body, of known modulus, against the depth of the tool that is pressed into it.
struct PressCurve {
  std::string label;             ///< the result and its run, for messages
  std::string material;          ///< name of its law, "neo_hookean"
  double youngs_modulus_Pa = 0;  ///< that it was simulated with, > 0
  double poissons_ratio = 0;
  /// Ascending from 0: the tool's way since the step before its first reaction, along the straight line to
  /// its deepest place; of steps that go deeper than all before.
  std::vector<double> depth_m;
  std::vector<double> force_N;  ///< against that way, one a depth
  double first_step_m = 0;      ///< way of the step with the first reaction: the depth's zero is known to it
  std::vector<std::string> notes;  ///< what scales with the modulus only nearly, one line each

  double deepest_m() const { return depth_m.back(); }
  /// Between steps linearly, 0 above depth 0, and below the deepest along the last line. Newtons.
  double force(double at_m) const;
};

/// Reads a run of a result, the only one for an empty name. Throws InputError, one line, where it has not
/// exactly one body, an elastic one, or not exactly one tool, or its reaction was not measured, or never is.
PressCurve readPress(const std::filesystem::path& file, const std::string& run);

/// The curve of a tool at `positions_m` (x, y, z of each step) with `reactions_N` (the same) on it; fills in
/// depth_m, force_N and first_step_m. Throws InputError, without a file, where there is none.
void takePress(const std::vector<double>& positions_m, const std::vector<double>& reactions_N,
               PressCurve& press);

}  // namespace fissure
