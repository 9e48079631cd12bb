#pragma once

#include "scenario/bodies.h"
#include "scenario/catalog.h"
#include "scenario/shapes_fields.h"

namespace fissure {

// The keys of a body (scenario/fields.h says how keys are described).

template <class Io>
void describe(Io& io, MaterialSettings& m) {
  io.field("linear_stiffness", m.linear_stiffness);
  io.field("angular_stiffness", m.angular_stiffness);
  io.field("volume_stiffness", m.volume_stiffness);
}

template <class Io>
void describe(Io& io, SolverSettings& s) {
  io.field("velocity_correction", s.velocity_correction);
  io.field("damping", s.damping);
  io.field("drag", s.drag);
  io.field("lift", s.lift);
  io.field("pressure", s.pressure);
  io.field("volume_conservation", s.volume_conservation);
  io.field("dynamic_friction", s.dynamic_friction);
  io.field("pose_matching", s.pose_matching);
  io.field("rigid_hardness", s.rigid_hardness);
  io.field("soft_hardness", s.soft_hardness);
  io.field("anchor_hardness", s.anchor_hardness);
  io.field("max_volume", s.max_volume);
  io.field("time_scale", s.time_scale);
  io.field("velocity_iterations", s.velocity_iterations);
  io.field("position_iterations", s.position_iterations);
  io.field("drift_iterations", s.drift_iterations);
  io.choice("aero_model", s.aero_model, catalog().aero_models);
}

template <class Io>
void describe(Io& io, ClusterSettings& c) {
  io.field("count", c.count);
  io.field("iterations", c.iterations);
  io.field("rigid_hardness", c.rigid_hardness);
  io.field("kinematic_hardness", c.kinematic_hardness);
  io.field("soft_hardness", c.soft_hardness);
  io.field("rigid_split", c.rigid_split);
  io.field("kinematic_split", c.kinematic_split);
  io.field("soft_split", c.soft_split);
  io.field("node_damping", c.node_damping);
  io.field("linear_damping", c.linear_damping);
  io.field("angular_damping", c.angular_damping);
  io.field("matching", c.matching);
}

template <class Io>
void describe(Io& io, BoxRegion& r) {
  io.required("min_m", r.min_m);
  io.required("max_m", r.max_m);
}

template <class Io>
void describe(Io& io, FixedRegion& r) {
  io.field("below_m", r.below_m);
  io.field("box", r.box);
}

template <class Io>
void describe(Io& io, GaugeSettings& g) {
  io.required("name", g.name);
  io.required("box", g.box);
}

template <class Io>
void describe(Io& io, FillSettings& f) {
  io.field("keep_surface", f.keep_surface);
  io.field("radius_edge_ratio", f.radius_edge_ratio);
  io.field("least_dihedral_deg", f.least_dihedral_deg);
  io.field("max_edge_m", f.max_edge_m);
}

template <class Io>
void describe(Io& io, CapsuleRegion& r) {
  io.required("from_m", r.from_m);
  io.required("to_m", r.to_m);
  io.required("radius_m", r.radius_m);
}

template <class Io>
void describe(Io& io, ElasticRegion& r) {
  io.required("name", r.name);
  io.field("tag", r.tag);
  io.field("box", r.box);
  io.field("capsule", r.capsule);
  io.choice("preset", r.preset, catalog().elastic_presets);
  io.whileReading([&] { applyPreset(r); });
  io.field("youngs_modulus_Pa", r.youngs_modulus_Pa);
  io.field("poissons_ratio", r.poissons_ratio);
  io.field("density_kg_m3", r.density_kg_m3);
  io.field("viscosity_Pa_s", r.viscosity_Pa_s);
}

template <class Io>
void describe(Io& io, ElasticSettings& e) {
  io.choice("preset", e.preset, catalog().elastic_presets);
  io.whileReading([&] { applyPreset(e); });
  io.choice("material", e.material, catalog().elastic_materials);
  io.field("youngs_modulus_Pa", e.youngs_modulus_Pa);
  io.field("poissons_ratio", e.poissons_ratio);
  io.field("density_kg_m3", e.density_kg_m3);
  io.field("viscosity_Pa_s", e.viscosity_Pa_s);
  io.field("mass_damping_1_s", e.mass_damping_1_s);
  io.field("friction", e.friction);
  io.field("fill", e.fill);
  io.field("regions", e.regions);
}

template <class Io>
void describe(Io& io, BodySettings& b) {
  io.required("name", b.name);
  io.tagged("shape", b.shape, catalog().body_shapes);
  io.field("position_m", b.position_m);
  io.field("orientation", b.orientation);
  io.choice("model", b.model, catalog().body_models);
  const bool shell = !b.isElastic();
  const char* const of_shell = "model shell";
  io.fieldIf(shell, of_shell, "mass_kg", b.mass_kg);
  io.fieldIf(shell, of_shell, "mass_from_faces", b.mass_from_faces);
  io.field("margin_m", b.margin_m);
  io.fieldIf(shell, of_shell, "bending_distance", b.bending_distance);
  io.fieldIf(shell, of_shell, "randomize_links", b.randomize_links);
  io.fieldIf(shell, of_shell, "pose_volume", b.pose_volume);
  io.fieldIf(shell, of_shell, "pose_frame", b.pose_frame);
  io.choiceIf(shell, of_shell, "soft_contact", b.soft_contact, catalog().soft_contacts);
  io.field("fixed", b.fixed);
  io.fieldIf(b.isElastic(), "model elastic", "elastic", b.elastic);
  io.fieldIf(shell, of_shell, "material", b.material);
  io.fieldIf(shell, of_shell, "solver", b.solver);
  io.fieldIf(shell, of_shell, "clusters", b.clusters);
  io.field("gauges", b.gauges);
}

}  // namespace fissure
