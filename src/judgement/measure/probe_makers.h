#pragma once

#include <memory>

#include "base/probe.h"
#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

// One maker per probe. The series of each probe, and their meaning, are documented at its class.

/// Depth of tools in tissue, and samples that passed through.
std::unique_ptr<Probe> makePenetrationProbe(const Scene& scene, const MeasureSettings& settings);

/// The probe, but looking at each `every`-th state and the last only.
std::unique_ptr<Probe> makeThinnedProbe(std::unique_ptr<Probe> probe, int every);

/// Depth of tissue below the ground, and the reaction of the ground.
std::unique_ptr<Probe> makeGroundProbe(const Scene& scene);

/// Soundness of tissue in a scene without tools (Soundness).
std::unique_ptr<Probe> makeSoundnessProbe(const Scene& scene);

/// The certificate of each step (Certifier).
std::unique_ptr<Probe> makeCertificateProbe(const Scene& scene);

/// Poses and velocities of the tools.
std::unique_ptr<Probe> makeToolProbe(const Scene& scene, double step_s);

/// States of nodes, counts of contacts, and the reaction.
std::unique_ptr<Probe> makeContactProbe(const Scene& scene);

/// Distances of coupled tools from the hand, and forces of the couplings.
std::unique_ptr<Probe> makeCouplingProbe(const Scenario& scenario);

/// Forces of the force laws.
std::unique_ptr<Probe> makeForceProbe(const Scenario& scenario, const Scene& scene);

/// Openings of clamps and the forces on them.
std::unique_ptr<Probe> makeClampProbe(const Scenario& scenario, const Scene& scene);

/// Volume, energy and inversion of the tissue.
std::unique_ptr<Probe> makeBodyProbe(const Scene& scene);

/// Energies, substeps and inverted elements of an elastic body.
std::unique_ptr<Probe> makeElasticProbe();

/// Mean displacements of the gauges.
std::unique_ptr<Probe> makeGaugeProbe(const Scene& scene);

/// Wall times of steps.
std::unique_ptr<Probe> makeTimingProbe(double step_s);

}  // namespace fissure
