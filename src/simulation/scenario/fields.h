#pragma once

#include "scenario/fields_tools.h"
#include "scenario/fields_world.h"
#include "scenario/tissues.h"

namespace fissure {

// Continues scenario/fields_world.h: motions of tools, pipelines, force laws, and the scenario as a whole.

template <class Io>
void describe(Io& io, MotionSegment& s) {
  const char* moving = "a segment that moves or rotates";
  io.field("hold_s", s.hold_s);
  io.field("move_to_m", s.move_to_m);
  io.field("rotate_to", s.rotate_to);
  io.field("open_to_m", s.open_to_m);
  io.field("open_to_deg", s.open_to_deg);
  io.field("speed_m_s", s.speed_m_s);
  io.field("duration_s", s.duration_s);
  io.choiceIf(!s.hold_s, moving, "timing", s.timing, catalog().timings);
  io.fieldIf(!s.hold_s && s.timing == Timing::trapezoidal, "timing trapezoidal", "ramp_fraction",
             s.ramp_fraction);
}

template <class Io>
void describe(Io& io, ScriptMotion& m) {
  io.required("start_m", m.start_m);
  io.field("start_orientation", m.start_orientation);
  io.field("start_opening_m", m.start_opening_m);
  io.field("start_opening_deg", m.start_opening_deg);
  io.field("segments", m.segments);
}

template <class Io>
void describe(Io& io, DeviceMapping& m) {
  io.choice("frame", m.frame, catalog().device_frames);
  io.fieldIf(m.frame == DeviceFrame::scene, "frame scene", "axes", m.axes);
  io.field("scale", m.scale);
  io.field("origin_device_m", m.origin_device_m);
  io.field("origin_scene_m", m.origin_scene_m);
  io.field("mount", m.mount);
}

template <class Io>
void describe(Io& io, ReplayMotion& m) {
  io.required("file", m.file);
  io.choice("layout", m.layout, catalog().log_layouts);
  const bool rows = m.layout == LogLayout::rows;
  io.fieldIf(rows, "layout rows", "time_column", m.time_column);
  io.field("rate_hz", m.rate_hz);
  io.fieldIf(rows, "layout rows", "position_columns", m.position_columns);
  io.choice("position_unit", m.position_unit, catalog().length_units);
  io.fieldIf(rows, "layout rows", "quaternion_columns", m.quaternion_columns);
  io.field("mapping", m.mapping);
  io.field("opening", m.opening);
  io.field("start_s", m.start_s);
  io.field("end_s", m.end_s);
  io.choice("interpolation", m.interpolation, catalog().interpolations);
  io.field("max_gap_s", m.max_gap_s);
  io.field("jump_m", m.jump_m);
}

template <class Io>
void describe(Io& io, PipelineSettings& p) {
  io.nameOr("name", p.name, "pipeline");
  io.requiredChoice("pipeline", p.pipeline, catalog().pipelines);
  io.choice("precision", p.precision, catalog().precisions);
  using enum ContactDetection;
  const bool rays = p.usesNodes();
  const std::string with_bullet = pipelinesWith({sdf, clusters}), with_sdf = pipelinesWith({sdf}),
                    with_rays = pipelinesWith({nodes});
  const char *sdf_only = with_sdf.c_str(), *rays_only = with_rays.c_str();
  io.choiceIf(p.usesSdf() || p.usesClusters(), with_bullet.c_str(), "settings", p.settings,
              catalog().settings);
  io.fieldIf(p.usesSdf(), sdf_only, "sdf_voxel_m", p.sdf_voxel_m);
  io.fieldIf(p.usesSdf(), sdf_only, "kinematic_hardness", p.kinematic_hardness);
  io.fieldIf(rays, rays_only, "ray_length_m", p.ray_length_m);
  io.fieldIf(rays, rays_only, "vertex_contacts", p.vertex_contacts);
  io.choiceIf(rays, rays_only, "response", p.response, catalog().responses);
  io.fieldIf(rays, rays_only, "sweeps", p.sweeps);
  io.fieldIf(rays, rays_only, "max_displacement_m", p.max_displacement_m);
  io.field("time_limit_s", p.time_limit_s);
}

template <class Io>
void describe(Io& io, ForceSettings& f) {
  io.nameOr("name", f.name, "model");
  io.requiredChoice("model", f.model, catalog().force_laws);
  io.choice("deformation", f.deformation, catalog().deformations);
  io.field("per_area", f.per_area);
  const auto coefficient = [&](bool applies, const char* when, const char* key, double& value) {
    if (applies && f.per_area) return io.required(key, value);  // a default in other units would mean nothing
    io.fieldIf(applies, when, key, value);
  };
  const bool hunt_crossley = f.model == "hunt_crossley", kelvin_voigt = f.model == "kelvin_voigt";
  io.choiceIf(hunt_crossley && !f.per_area, "model hunt_crossley without per_area", "tissue", f.tissue,
              catalog().tissues);
  io.whileReading([&] { applyTissue(f); });
  coefficient(true, "", "k", f.k);
  coefficient(hunt_crossley, "model hunt_crossley", "lambda", f.lambda);
  io.fieldIf(hunt_crossley, "model hunt_crossley", "n", f.n);
  coefficient(kelvin_voigt, "model kelvin_voigt", "c", f.c);
  io.choiceIf(hunt_crossley || kelvin_voigt, "models hunt_crossley and kelvin_voigt", "rate", f.rate,
              catalog().rates);
}

template <class Io>
void describe(Io& io, Expectation& e) {
  io.required("quantity", e.quantity);
  io.field("pipeline", e.pipeline);
  io.field("value", e.value);
  io.field("tolerance", e.tolerance);
  io.field("min", e.min);
  io.field("max", e.max);
}

template <class Io>
void describe(Io& io, Scenario& s) {
  io.required("format", s.format);
  io.required("name", s.name);
  io.text("description", s.description);
  io.field("time", s.time);
  io.field("world", s.world);
  io.field("ground", s.ground);
  io.required("bodies", s.bodies);
  io.field("tools", s.tools);
  io.required("pipelines", s.pipelines);
  io.field("force", s.force);
  io.field("record", s.record);
  io.field("measure", s.measure);
  io.field("expect", s.expect);
}

}  // namespace fissure
