#pragma once

#include <array>

namespace fissure {

/// The scale on which values of a quantity are shown.
enum class PlotScale {
  length,           ///< from metres to mm
  prefixed,         ///< in the stored unit with an SI prefix
  plain,            ///< as stored: counts, degrees
  relative_percent  ///< change since the first row, in per cent of it
};

/// A quantity that the page plots over time. For a vector its length is shown, unless `select` is "xyz".
struct PlotQuantity {
  const char* dataset = "";
  const char* section = "";
  /// Title of the plot, in which {} stands for the label along `each`.
  const char* title = "";
  PlotScale scale = PlotScale::plain;
  const char* note = "";
  /// Axis with one plot per label.
  const char* each = "";
  /// Axis whose label is chosen by a selector.
  const char* select = "";
  bool several_only = false;  ///< only where `each` has several labels
  bool may_be_log = false;    ///< a logarithmic axis is used where the runs are far apart
};

inline constexpr std::array<PlotQuantity, 36> plot_quantities = {{
    {"penetration_depth", "Penetration", "Penetration depth", PlotScale::length,
     "deepest tool sample in tissue, or tissue vertex in a tool"},
    {"inversion_aware_depth", "Penetration", "Depth with inverted tissue", PlotScale::length,
     "the shortest way out of all that the tissue fills, folds and what is inside out included"},
    {"ground_depth", "Penetration", "Tissue below the ground", PlotScale::length,
     "its lowest vertex: Bullet's ground gives way under load"},
    {"stand_off", "Penetration", "Distance between tool and tissue", PlotScale::length,
     "while nothing penetrates, up to 10 mm"},
    {"passed_through", "Penetration", "Passed through", PlotScale::plain,
     "tool samples that went in on one side of the tissue and out on another, since the start"},
    {"inverted_triangles", "Penetration", "Inverted triangles", PlotScale::plain,
     "tissue triangles turned inside out or folded over, where depth can hide"},
    {"force", "Force", "Force on the tools", PlotScale::prefixed, "length of the sum over all tools", "",
     "law"},
    {"force_elastic", "Force", "Elastic term", PlotScale::prefixed, "summed over the triangles", "", "law"},
    {"force_viscous", "Force", "Viscous term", PlotScale::prefixed,
     "summed over the triangles; negative while tissue springs back", "", "law"},
    {"adhesion_clamped", "Force", "Clamped triangles", PlotScale::plain,
     "the law would have pulled there, and was set to 0", "", "law"},
    {"reaction_force", "Force", "Reaction", PlotScale::prefixed,
     "what the contacts took from the tissue: a force in newtons of an elastic body; of a shell of springs "
     "it "
     "grows as 1/dt²; no force with response: none"},
    {"max_pressure", "Force", "Largest pressure on the tissue", PlotScale::prefixed,
     "normal stress of the contacts at a vertex of an elastic body"},
    {"tool_force", "Force", "Force on {}", PlotScale::prefixed, "length", "tool", "law", true},
    {"tool_reaction", "Force", "Reaction on {}", PlotScale::prefixed, "length", "tool", "", true},
    {"ground_reaction", "Force", "Reaction on the ground", PlotScale::prefixed,
     "of pipelines that hold tissue on it themselves: weight, and what the tools press through"},
    {"jaw_opening", "Clamps", "Opening of {}", PlotScale::length, "", "clamp"},
    {"jaw_angle", "Clamps", "Opening of {}", PlotScale::plain, "", "clamp"},
    {"clamp_force", "Clamps", "Force on both jaws of {}", PlotScale::prefixed, "length of the sum", "clamp",
     "law"},
    {"clamp_reaction", "Clamps", "Reaction on both jaws of {}", PlotScale::prefixed, "length of the sum",
     "clamp"},
    {"coupling_force", "Couplings", "Force of the coupling on {}", PlotScale::prefixed,
     "length; its opposite is what the hand feels", "coupling"},
    {"gauge_displacement", "Gauges", "Displacement of {}", PlotScale::length,
     "mean of the gauge's vertices, since time 0", "gauge", "xyz"},
    {"contact_count", "Contacts", "Contacts", PlotScale::plain, "that act on the tissue"},
    {"candidate_count", "Contacts", "Candidates", PlotScale::plain, "contacts that the detector proposed"},
    {"infeasible_count", "Contacts", "Infeasible contacts", PlotScale::plain,
     "candidates excluded by their node's partner"},
    {"capped_count", "Contacts", "Capped contacts", PlotScale::plain,
     "whose displacement hit the limit of one step"},
    {"colliding_triangles", "Contacts", "Colliding triangles", PlotScale::plain,
     "tissue triangles with a vertex in contact"},
    {"kinetic_energy", "Energy and volume", "Kinetic energy", PlotScale::prefixed,
     "of the tissue, from the engine's velocities; without meaning with response: none", "", "", false, true},
    {"stored_energy", "Energy and volume", "Elastic energy", PlotScale::prefixed, "of an elastic body"},
    {"gravity_energy", "Energy and volume", "Energy in gravity", PlotScale::prefixed,
     "since the body at rest"},
    {"viscous_loss", "Energy and volume", "Lost by viscosity", PlotScale::prefixed, "since time 0"},
    {"mass_damping_loss", "Energy and volume", "Lost by mass damping", PlotScale::prefixed, "since time 0"},
    {"tool_work", "Energy and volume", "Work of the tools", PlotScale::prefixed, "since time 0"},
    {"contact_loss", "Energy and volume", "Lost in contacts", PlotScale::prefixed,
     "work of the tools that did not reach the tissue, since time 0"},
    {"energy_error", "Energy and volume", "Energy that does not add up", PlotScale::prefixed,
     "all of the above against each other, since time 0"},
    {"inverted_elements", "Energy and volume", "Inverted elements", PlotScale::plain,
     "tetrahedra turned inside out"},
    {"volume", "Energy and volume", "Volume of {}", PlotScale::relative_percent, "change since time 0",
     "body"},
}};

}  // namespace fissure
