#include "check/scenario_warnings.h"

#include "check/plausibility.h"
#include "measure/node_spacing.h"

namespace fissure {

namespace {

constexpr int kPathPoints = 1000;

/// Whether somewhere on its way a box moves obliquely.
bool movesObliquely(const Motion& motion) {
  Pose before = motion.poseAt(0);
  for (int i = 1; i <= kPathPoints; ++i) {
    const Pose now = motion.poseAt(motion.duration_s() * i / kPathPoints);
    if (isOblique(now.rotateToBody(now.position_m - before.position_m))) return true;
    before = now;
  }
  return false;
}

}  // namespace

std::vector<std::string> scenarioWarnings(const CheckedScenario& checked) {
  std::vector<std::string> warnings = plausibilityWarnings(checked);
  const Scenario& scenario = checked.loaded.scenario;
  const auto spacing = widestNodeSpacing(checked.prepared.scene);
  if (!spacing) return warnings;
  if (spacing->ratio() > kWideNodes)
    warnings.push_back("warning: tools." + spacing->tool + ".nodes: " +
                       wideNodesText(spacing->spacing_m, spacing->ratio()) + " (body " + spacing->body + ")");
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const ToolSettings& tool = scenario.tools[t];
    if (tool.nodes.narrow_rows == 0 || tool.nodePlacement() != NodePlacement::grid) continue;
    if (!tool.clamp && !movesObliquely(*checked.prepared.motions[t])) continue;
    warnings.push_back(
        "warning: tools." + tool.name +
        ".nodes.narrow_rows: the blade moves obliquely to its faces, where nodes on narrow ones "
        "tear tissue, expected 0 or a look at a run with 0");
  }
  return warnings;
}

}  // namespace fissure
