#pragma once

#include <memory>
#include <vector>

#include "base/scene.h"
#include "motion/motion.h"
#include "scenario/scenario.h"

namespace fissure {

/// The scene and the motions of a scenario, for which its files are read once; shared by the checks, plans
/// and runs of a process.
struct PreparedScenario {
  Scene scene;
  std::vector<std::unique_ptr<Motion>> motions;  ///< one per tool of the scenario

  /// Time until the last tool motion ends; 0 without tools.
  double longestMotion_s() const;
};

/// Builds scene and motions. `with_nodes`: whether tools get nodes. Throws InputError for a file that cannot
/// be used (buildScene, makeMotion).
PreparedScenario prepareScenario(const Scenario& scenario, bool with_nodes);

/// The motions of the tools of a scenario, in their order; a log that several tools name is read once. Throws
/// as makeMotion.
std::vector<std::unique_ptr<Motion>> makeMotions(const Scenario& scenario);

}  // namespace fissure
