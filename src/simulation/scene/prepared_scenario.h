#pragma once

#include <memory>
#include <vector>

#include "base/scene.h"
#include "motion/motion.h"
#include "scenario/scenario.h"

namespace fissure {

/// What a scenario's files hold, read once: from here checks, plans and runs of one process take it.
struct PreparedScenario {
  Scene scene;
  std::vector<std::unique_ptr<Motion>> motions;  ///< one per tool of the scenario

  /// Until the last tool stands still; 0 without tools.
  double longestMotion_s() const;
};

/// Builds scene and motions. `with_nodes`: the tools get their nodes, which pipelines that use none do not
/// need. Throws InputError for a file that cannot be used (buildScene, makeMotion).
PreparedScenario prepareScenario(const Scenario& scenario, bool with_nodes);

/// The motion of each tool of a scenario, in its order; a log that several name is read once.
std::vector<std::unique_ptr<Motion>> makeMotions(const Scenario& scenario);

}  // namespace fissure
