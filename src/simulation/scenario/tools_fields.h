#pragma once

#include "scenario/catalog.h"
#include "scenario/clamps_fields.h"
#include "scenario/motions_fields.h"
#include "scenario/shapes_fields.h"
#include "scenario/tools.h"

namespace fissure {

// The keys of a tool (scenario/fields.h says how keys are described).

template <class Io>
void describe(Io& io, NodeSettings& n) {
  io.choice("placement", n.placement, catalog().node_placements);
  const bool grid = n.placement == NodePlacement::grid;
  io.fieldIf(grid, "placement grid", "resolution", n.resolution);
  io.fieldIf(grid, "placement grid", "narrow_rows", n.narrow_rows);
  io.fieldIf(!grid, "placement centroids", "max_spacing_m", n.max_spacing_m);
  io.fieldIf(!grid, "placement centroids", "pairing_limit", n.pairing_limit);
  io.fieldIf(!grid, "placement centroids", "lone_nodes", n.lone_nodes);
  io.fieldIf(!grid, "placement centroids", "rim_nodes", n.rim_nodes);
}

template <class Io>
void describe(Io& io, CouplingSettings& c) {
  io.required("mass_kg", c.mass_kg);
  io.required("stiffness_N_m", c.stiffness_N_m);
  io.required("damping_N_s_m", c.damping_N_s_m);
  io.required("force", c.force);
}

template <class Io>
void describe(Io& io, ToolSettings& t) {
  io.required("name", t.name);
  io.tagged("shape", t.shape, catalog().tool_shapes);
  io.field("clamp", t.clamp);
  t.nodes.placement = t.nodePlacement();
  io.field("nodes", t.nodes);
  io.field("friction", t.friction);
  io.field("force_limit_N", t.force_limit_N);
  io.field("coupling", t.coupling);
  io.tagged("motion", t.motion, catalog().motions);
}

}  // namespace fissure
