#include "measure/probes.h"

#include <algorithm>

#include "measure/final_state_probe.h"
#include "measure/probe_makers.h"

namespace fissure {

std::vector<std::unique_ptr<Probe>> makeProbes(const Scenario& scenario, const Scene& scene) {
  std::vector<std::unique_ptr<Probe>> probes;
  if (!scene.tools.empty()) {
    const int every = stepsPerMeasurement(scenario.measure);
    probes.push_back(makePenetrationProbe(scene, scenario.measure));
    if (scenario.measure.certify) probes.push_back(makeThinnedProbe(makeCertificateProbe(scene), every));
    probes.push_back(makeToolProbe(scene, scenario.time.step_s));
    probes.push_back(makeContactProbe(scene));
  } else {
    probes.push_back(makeSoundnessProbe(scene));
  }
  if (scene.ground_height_m) probes.push_back(makeGroundProbe(scene));
  if (std::any_of(scenario.tools.begin(), scenario.tools.end(),
                  [](const ToolSettings& tool) { return tool.coupling.has_value(); }))
    probes.push_back(makeCouplingProbe(scenario));
  if (!scenario.force.empty()) probes.push_back(makeForceProbe(scenario, scene));
  if (!scene.clamps.empty()) probes.push_back(makeClampProbe(scenario, scene));
  probes.push_back(makeBodyProbe(scene));
  if (std::any_of(scene.bodies.begin(), scene.bodies.end(),
                  [](const SceneBody& b) { return b.volume.has_value(); }))
    probes.push_back(makeElasticProbe());
  if (std::any_of(scene.bodies.begin(), scene.bodies.end(),
                  [](const SceneBody& b) { return !b.gauges.empty(); }))
    probes.push_back(makeGaugeProbe(scene));
  probes.push_back(makeTimingProbe(scenario.time.step_s));
  probes.push_back(std::make_unique<FinalStateProbe>());
  return probes;
}

}  // namespace fissure
