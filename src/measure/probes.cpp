#include "measure/probes.h"

#include <algorithm>

#include "measure/body_probe.h"
#include "measure/clamp_probe.h"
#include "measure/contact_probe.h"
#include "measure/coupling_probe.h"
#include "measure/final_state_probe.h"
#include "measure/force_probe.h"
#include "measure/gauge_probe.h"
#include "measure/penetration_probe.h"
#include "measure/timing_probe.h"
#include "measure/tool_probe.h"

namespace fissure {

std::vector<std::unique_ptr<Probe>> makeProbes(const Scenario& scenario, const Scene& scene) {
  std::vector<std::unique_ptr<Probe>> probes;
  if (!scene.tools.empty()) {
    probes.push_back(std::make_unique<PenetrationProbe>(scene, scenario.measure));
    probes.push_back(std::make_unique<ToolProbe>(scene));
    probes.push_back(std::make_unique<ContactProbe>(scene));
  }
  if (std::any_of(scenario.tools.begin(), scenario.tools.end(),
                  [](const ToolSettings& tool) { return tool.coupling.has_value(); }))
    probes.push_back(std::make_unique<CouplingProbe>(scenario));
  if (!scenario.force.empty()) probes.push_back(std::make_unique<ForceProbe>(scenario, scene));
  if (!scene.clamps.empty()) probes.push_back(std::make_unique<ClampProbe>(scenario, scene));
  probes.push_back(std::make_unique<BodyProbe>(scene));
  if (std::any_of(scene.bodies.begin(), scene.bodies.end(),
                  [](const SceneBody& b) { return !b.gauges.empty(); }))
    probes.push_back(std::make_unique<GaugeProbe>(scene));
  probes.push_back(std::make_unique<TimingProbe>(scenario.time.step_s));
  probes.push_back(std::make_unique<FinalStateProbe>());
  return probes;
}

}  // namespace fissure
