#pragma once

#include "scenario/catalog.h"
#include "scenario/key.h"

namespace fissure {

// Settings of a body of model shell, Bullet's shell of springs. Names of Bullet's fields stand in brackets.

/// Stiffness of all links of a body (btSoftBody::Material), without a unit.
struct MaterialSettings {
  double linear_stiffness = 1.0;
  double angular_stiffness = 1.0;
  double volume_stiffness = 1.0;

  bool operator==(const MaterialSettings&) const = default;
};

/// Where drag and lift act on a soft body: Bullet's eAeroModel, in its order.
enum class AeroModel {
  V_Point,
  V_TwoSided,
  V_TwoSidedLiftDrag,
  V_OneSided,
  F_TwoSided,
  F_TwoSidedLiftDrag,
  F_OneSided,
};

/// Contact between two soft bodies.
enum class SoftContact {
  none,      ///< they ignore each other
  vertices,  ///< Bullet tests vertices of each against faces of the other
  clusters,  ///< Bullet tests clusters of both
};

/// Settings of Bullet's soft-body solver: btSoftBody::Config, field by field, with Bullet's own defaults.
struct SolverSettings {
  double velocity_correction = 1.0;
  double damping = 0.0;
  double drag = 0.0;
  double lift = 0.0;
  double pressure = 0.0;
  double volume_conservation = 0.0;
  double dynamic_friction = 0.2;
  double pose_matching = 0.0;
  double rigid_hardness = 1.0;
  double soft_hardness = 1.0;
  double anchor_hardness = 0.7;
  double max_volume = 1.0;
  double time_scale = 1.0;
  int velocity_iterations = 0;
  int position_iterations = 1;
  int drift_iterations = 0;
  AeroModel aero_model = AeroModel::V_Point;

  bool operator==(const SolverSettings&) const = default;
};

template <class Io>
void describe(Io& io, MaterialSettings& m) {
  io.field("linear_stiffness", m.linear_stiffness,
           Key("Stiffness of links against stretching, as the share of an error that one iteration corrects "
               "[m_kLST]. It is no modulus: how stiff tissue is depends on step, mesh and iterations too.")
               .share());
  io.field("angular_stiffness", m.angular_stiffness, Key("Stiffness of bending links [m_kAST].").share());
  io.field("volume_stiffness", m.volume_stiffness, Key("Stiffness of volume [m_kVST].").share());
}

template <class Io>
void describe(Io& io, SolverSettings& s) {
  io.field("velocity_correction", s.velocity_correction,
           Key("Baumgarte factor of the drift solver [kVCF].").noUnit().atLeast(0));
  io.field("damping", s.damping, Key("Share of the velocity that is lost in a step [kDP].").share());
  io.field("drag", s.drag, Key("Coefficient of drag against the air [kDG].").noUnit().atLeast(0));
  io.field("lift", s.lift, Key("Coefficient of lift in the air [kLF].").noUnit().atLeast(0));
  io.field(
      "pressure", s.pressure,
      Key("Coefficient of a pressure inside the closed surface [kPR]; negative values draw the surface in.")
          .noUnit());
  io.field("volume_conservation", s.volume_conservation,
           Key("Coefficient of the force that restores the volume at rest [kVC].").noUnit().atLeast(0));
  io.field("dynamic_friction", s.dynamic_friction,
           Key("Coulomb's coefficient of the tissue; contacts rub with its product with the friction of the "
               "tool or the ground [kDF].")
               .share());
  io.field(
      "pose_matching", s.pose_matching,
      Key("Share of the distance to the matched shape at rest that vertices cover in a step [kMT].").share());
  io.field("rigid_hardness", s.rigid_hardness,
           Key("Hardness of contacts with dynamic rigid bodies [kCHR].").share());
  io.field("soft_hardness", s.soft_hardness, Key("Hardness of contacts with soft bodies [kSHR].").share());
  io.field("anchor_hardness", s.anchor_hardness, Key("Hardness of anchors [kAHR].").share());
  io.field("max_volume", s.max_volume,
           Key("Largest volume of pose matching over that at rest [maxvolume].").noUnit().above(0));
  io.field("time_scale", s.time_scale,
           Key("The body's own time over the scene's [timescale]. Velocities, energy, momentum and reaction "
               "of the body are then in its own time.")
               .noUnit()
               .above(0));
  io.field("velocity_iterations", s.velocity_iterations,
           Key("Iterations of the velocity solver in a step [viterations].").count(0, 1000));
  io.field("position_iterations", s.position_iterations,
           Key("Iterations of the position solver in a step [piterations]; more of them make tissue stiffer.")
               .count(1, 1000));
  io.field("drift_iterations", s.drift_iterations,
           Key("Iterations of the drift solver in a step [diterations].").count(0, 1000));
  io.field("aero_model", s.aero_model,
           Key("Where drag and lift act on the body [aeromodel].").oneOf(catalog().aero_models));
}

}  // namespace fissure
