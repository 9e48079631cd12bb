#include "scene/prepared_scenario.h"

#include <algorithm>

#include "scene/build_scene.h"

namespace fissure {

double PreparedScenario::longestMotion_s() const {
  double longest_s = 0;
  for (const auto& motion : motions) longest_s = std::max(longest_s, motion->duration_s());
  return longest_s;
}

PreparedScenario prepareScenario(const Scenario& scenario, bool with_nodes) {
  return {.scene = buildScene(scenario, with_nodes), .motions = makeMotions(scenario)};
}

std::vector<std::unique_ptr<Motion>> makeMotions(const Scenario& scenario) {
  std::vector<std::unique_ptr<Motion>> motions;
  const LogFiles files;
  for (const ToolSettings& tool : scenario.tools)
    motions.push_back(makeMotion(tool, scenario.directory, files));
  return motions;
}

}  // namespace fissure
