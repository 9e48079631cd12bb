#pragma once

#include <optional>

#include "base/geometry.h"
#include "scenario/key.h"

namespace fissure {

struct TimeSettings {
  double step_s = 0.001;
  double settle_s = 0.0;
  std::optional<double> duration_s;

  bool operator==(const TimeSettings&) const = default;
};

/// Fields of Bullet's world that soft bodies read (btSoftBodyWorldInfo).
struct WorldSettings {
  Vec3 gravity_m_s2 = {0, -9.81, 0};
  double air_density_kg_m3 = 1.2;
  double max_displacement_m = 1000.0;

  bool operator==(const WorldSettings&) const = default;
};

/// A horizontal half-space under the tissue. With pipeline swept and with ground_contact half_space it is a
/// further obstacle of the pipeline's own contacts (contact/METHOD.md 11). Otherwise Bullet solves one
/// contact per vertex, which holds the vertex a margin above the ground and gives way under load
/// (engine/METHOD.md 2).
struct GroundSettings {
  double height_m = 0.0;
  double friction = 0.5;
  double hardness = 0.3;

  bool operator==(const GroundSettings&) const = default;
};

template <class Io>
void describe(Io& io, TimeSettings& t) {
  io.field("step_s", t.step_s, Key("Fixed time step of the simulation.").above(0));
  io.field(
      "settle_s", t.settle_s,
      Key("Time that is simulated before time zero with the tools at their first pose, and not recorded.")
          .atLeast(0));
  io.field("duration_s", t.duration_s,
           Key("Time that is simulated and recorded from time zero, at least one step.")
               .above(0)
               .otherwise("until the longest tool motion ends"));
}

template <class Io>
void describe(Io& io, WorldSettings& w) {
  io.field("gravity_m_s2", w.gravity_m_s2, Key("Acceleration of gravity, in the scene's frame; y is up."));
  io.field("air_density_kg_m3", w.air_density_kg_m3,
           Key("Density of the air, which matters with drag or lift of a shell alone.").atLeast(0));
  io.field("max_displacement_m", w.max_displacement_m,
           Key("Bullet's cap on the velocity change by forces in a step, times the step.").above(0));
}

template <class Io>
void describe(Io& io, GroundSettings& g) {
  io.field("height_m", g.height_m, Key("Height (y) of the ground in the scene's frame."));
  io.field("friction", g.friction,
           Key("Coefficient of friction of the ground, times that of the body. With swept and half_space the "
               "product is Coulomb's coefficient; Bullet's contact takes that share of what slips, once per "
               "iteration.")
               .noUnit()
               .atLeast(0));
  io.field("hardness", g.hardness,
           Key("Share of its overlap by which Bullet's contact lifts a vertex, besides taking back its "
               "motion into "
               "the ground. 1 throws it as far above: under load tissue then rattles at metres per second.")
               .share());
}

}  // namespace fissure
