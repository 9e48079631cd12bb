#pragma once

#include <optional>
#include <string>
#include <variant>

#include "scenario/clamps.h"
#include "scenario/motions.h"
#include "scenario/nodes.h"
#include "scenario/shapes.h"

namespace fissure {

/// A virtual coupling: the tool has a mass and hangs on a hand by a spring and a damper; the prescribed
/// motion is that of the hand. Forces of the tissue move the tool too; gravity does not.
struct CouplingSettings {
  double mass_kg = 0;
  double stiffness_N_m = 0;
  double damping_N_s_m = 0;
  std::string force;

  bool isPushedByContacts() const { return force == "reaction"; }

  bool operator==(const CouplingSettings&) const = default;
};

/// A rigid tool that moves as prescribed, or follows a prescribed motion by a coupling. With `clamp` it
/// stands for two rigid tools, the jaws NAME_left and NAME_right.
struct ToolSettings {
  std::string name;
  SurfaceShape shape = BoxShape{};
  bool mirrored = false;  ///< the shape is mirrored in x = 0; set by rigidTools only
  std::optional<ClampSettings> clamp;
  NodeSettings nodes;
  double friction = 0.0;
  std::optional<double> force_limit_N;
  std::optional<CouplingSettings> coupling;
  ToolMotion motion;

  /// The placement of nodes; by default a grid on boxes, else centroids.
  NodePlacement nodePlacement() const {
    const bool box = std::holds_alternative<BoxShape>(shape);
    return nodes.placement.value_or(box ? NodePlacement::grid : NodePlacement::centroids);
  }

  bool operator==(const ToolSettings&) const = default;
};

template <class Io>
void describe(Io& io, CouplingSettings& c) {
  io.field("mass_kg", c.mass_kg, Key("Mass of the tool.").above(0).required());
  io.field("stiffness_N_m", c.stiffness_N_m,
           Key("Stiffness of the spring between hand and tool; every value is stable at every step.")
               .above(0)
               .required());
  io.field("damping_N_s_m", c.damping_N_s_m, Key("Damping between hand and tool.").atLeast(0).required());
  io.field("force", c.force,
           Key("What tissue does to the tool: the name of an entry of `force`, whose force of the step "
               "before moves it, without what contacts rub; or `reaction`, where the contacts themselves "
               "move it as they move the tissue, so that what the tool gains the tissue loses.")
               .required());
}

template <class Io>
void describe(Io& io, ToolSettings& t) {
  io.field("name", t.name,
           Key("Name of the tool, once among the tools: 1 to 64 letters, digits, '_' and '-'.")
               .itemName()
               .required());
  io.tagged("shape", t.shape,
            Key("Surface of the tool, in the tool's own frame; of a clamp that of the right jaw.")
                .oneOf(catalog().tool_shapes)
                .required());
  io.field("clamp", t.clamp,
           Key("Makes the tool a clamp of two rigid jaws, which meet the tissue and not each other. In its "
               "frame they lie left and right of the plane x = 0, and each goes half of the opening.")
               .otherwise("no clamp: the tool is one rigid piece"));
  t.nodes.placement = t.nodePlacement();
  io.field("nodes", t.nodes, Key("Where nodes stand on the tool, for the pipelines that use them."));
  io.field(
      "friction", t.friction,
      Key("Coulomb's coefficient of the tool; contacts rub with its product with the friction of the tissue "
          "(pipeline cluster: the smaller of the two). Ray casting needs response momentum for it.")
          .noUnit()
          .atLeast(0));
  io.field("force_limit_N", t.force_limit_N,
           Key("Largest force of the haptic device that the tool stands for (Falcon: 8 N by CHAI3D's "
               "specification). Forces beyond it are recorded as they are, with a flag.")
               .above(0)
               .otherwise("no device, no limit"));
  io.field("coupling", t.coupling,
           Key("Gives the tool a mass, led by a hand through a spring and a damper; `motion` is then the "
               "hand's, and tissue pushes the tool back. Gravity does not pull at it.")
               .otherwise("none: the tool is where its motion says"));
  io.tagged("motion", t.motion, Key("Where the tool goes.").oneOf(catalog().motions).required());
}

}  // namespace fissure
