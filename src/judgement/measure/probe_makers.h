#pragma once

#include <memory>

#include "base/probe.h"
#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

// One a probe; the series of each and their meaning stand at its class.

/// How deep tools are in tissue, and what passed through.
std::unique_ptr<Probe> makePenetrationProbe(const Scene& scene, const MeasureSettings& settings);

/// How deep tissue stands below the scene's ground, and what that bears.
std::unique_ptr<Probe> makeGroundProbe(const Scene& scene);

/// Whether tissue is sound by itself, in a scene without tools.
std::unique_ptr<Probe> makeSoundnessProbe(const Scene& scene);

/// Which steps are proved free of overlap.
std::unique_ptr<Probe> makeCertificateProbe(const Scene& scene);

/// Where the tools are and how fast they move.
std::unique_ptr<Probe> makeToolProbe(const Scene& scene, double step_s);

/// What nodes and contacts did, and the reaction.
std::unique_ptr<Probe> makeContactProbe(const Scene& scene);

/// How far coupled tools stay behind the hand, and with what force.
std::unique_ptr<Probe> makeCouplingProbe(const Scenario& scenario);

/// What the force laws say.
std::unique_ptr<Probe> makeForceProbe(const Scenario& scenario, const Scene& scene);

/// Openings of clamps and the forces on them.
std::unique_ptr<Probe> makeClampProbe(const Scenario& scenario, const Scene& scene);

/// Volume, energy and inversion of the tissue.
std::unique_ptr<Probe> makeBodyProbe(const Scene& scene);

/// Where the energy of an elastic body goes, and what its elements do.
std::unique_ptr<Probe> makeElasticProbe();

/// Mean displacements of the gauges.
std::unique_ptr<Probe> makeGaugeProbe(const Scene& scene);

/// What a step costs.
std::unique_ptr<Probe> makeTimingProbe(double step_s);

}  // namespace fissure
