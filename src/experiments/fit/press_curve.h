#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace fissure {

/// The reaction of one elastic body of known modulus over the depth of a tool that is pressed into it.
struct PressCurve {
  std::string label;  ///< the result and its run, for messages
  /// Name of its material law, as "neo_hookean".
  std::string material;
  double youngs_modulus_Pa = 0;  ///< modulus of the simulation, > 0
  double poissons_ratio = 0;
  /// Displacement of the tool since the step before its first reaction, along the straight line to its
  /// deepest position, ascending from 0; only steps that are deeper than all before.
  std::vector<double> depth_m;
  std::vector<double> force_N;  ///< reaction against that displacement, one per depth
  double first_step_m = 0;  ///< displacement in the step with the first reaction: the uncertainty of depth 0
  std::vector<std::string> notes;  ///< forces that scale with the modulus only approximately, one line each

  double deepest_m() const { return depth_m.back(); }
  /// Force at a depth, newtons: linear between steps, 0 above depth 0, extrapolated linearly below the
  /// deepest.
  double force(double at_m) const;
};

/// Throws InputError about `file` unless `scenario` has exactly one body, which is elastic, and exactly one
/// tool.
void requirePress(const Scenario& scenario, const std::filesystem::path& file);

/// Reads the curve of a run of a result; an empty name stands for the only run. Throws InputError, one line,
/// where the scenario is no such press, or no reaction was recorded or all reactions are zero.
PressCurve readPress(const std::filesystem::path& file, const std::string& run);

/// Fills in depth_m, force_N and first_step_m from a tool's `positions_m` and the `reactions_N` on it (both
/// x, y, z per step, scene frame). Throws InputError, without a file, where there is no reaction.
void takePress(const std::vector<double>& positions_m, const std::vector<double>& reactions_N,
               PressCurve& press);

}  // namespace fissure
