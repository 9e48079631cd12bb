#pragma once

#include <cstdint>
#include <vector>

namespace fissure {

/// The steps of a run that its pilot simulates: the whole path of the tools in fewer steps. Most of the path
/// is passed in jumps over many steps, so that the tissue reaches the deformation that it has in the run.
/// Between two jumps lies a window of a few steps at the run's own speed, because the cost of a step also
/// depends on speed.
struct Pace {
  /// [step of the pilot, from 0] the step of the run whose tool poses it has, ascending from 0 to the run's
  /// last step; one entry more than the pilot has steps.
  std::vector<std::int64_t> run_steps;
  /// For each window its last steps, as numbers of the pilot's steps, ascending. Their costs are taken as
  /// those of the run; in the earlier steps of the window the effects of the jump decay.
  std::vector<std::vector<std::int64_t>> windows;
  /// [step of the pilot, from 0] whether the step is one at the run's own speed; entry 0 has no meaning.
  std::vector<bool> is_in_window;

  std::int64_t steps() const { return static_cast<std::int64_t>(run_steps.size()) - 1; }
  std::int64_t stepsOfRun() const { return run_steps.back(); }
  /// Speed of the tools in step `step` + 1 of the pilot over that in step `step`; of step 0, before which the
  /// tissue settles, over the run's own. 1 after the last step, and within a jump, where displacements differ
  /// only by rounding.
  double speedChangeAfter(std::int64_t step) const;
};

/// The pace of a pilot for a run of `steps` steps with about one in `one_in` of them, but not fewer than
/// three windows need. A run of at most twice that number is simulated completely.
Pace paceOf(std::int64_t steps, int one_in);

/// The cost of all steps of the run, from the costs of the pilot's steps (entry 0 is ignored): linear between
/// the middles of two windows, constant before the first and after the last. The first and the last step, in
/// which some work is done only once, count as they are. Only the windows `from`, `from + every` and so on
/// are used.
double costOfRun(const Pace& pace, const std::vector<double>& step_costs, std::size_t every = 1,
                 std::size_t from = 0);

}  // namespace fissure
