#pragma once

#include <array>

#include "scenario/bodies_fields.h"
#include "scenario/catalog.h"
#include "scenario/forces_fields.h"
#include "scenario/pipelines_fields.h"
#include "scenario/scenario.h"
#include "scenario/tools_fields.h"

namespace fissure {

// The keys of every map of a scenario file, once, in the order in which they are written: here those of the
// scenario as a whole, what surrounds the bodies, record and expectations; of the rest in the *_fields.h
// beside the structs. MapReader and MapWriter are the two kinds of Io: what one writes, the other reads.
//   io.required(key, value)            must be in the file
//   io.field(key, value)               may be left out: the struct's default, or no value, stands
//   io.fieldIf(applies, when, key, value)   has a meaning only if `applies`; an error elsewhere
//   io.choice / io.requiredChoice      a name from a table of the catalog, for a value of an enum
//   io.choices(key, values, table)     a list of such names, which may be left out
//   io.tagged(key, value, table)       a map whose `type` names the alternative
//   io.whileReading(fill)              sets the defaults of keys that follow by those before
//   io.nameOr(key, value, other_key)   a name that may be left out: then what `other_key` says

template <class Io>
void describe(Io& io, TimeSettings& t) {
  io.field("step_s", t.step_s);
  io.field("settle_s", t.settle_s);
  io.field("duration_s", t.duration_s);
}

template <class Io>
void describe(Io& io, WorldSettings& w) {
  io.field("gravity_m_s2", w.gravity_m_s2);
  io.field("air_density_kg_m3", w.air_density_kg_m3);
  io.field("max_displacement_m", w.max_displacement_m);
}

template <class Io>
void describe(Io& io, GroundSettings& g) {
  io.field("height_m", g.height_m);
  io.field("friction", g.friction);
  io.field("hardness", g.hardness);
}

template <class Io>
void describe(Io& io, CameraSettings& c) {
  io.field("position_m", c.position_m);
  io.field("look_at_m", c.look_at_m);
  io.field("up", c.up);
  io.field("field_of_view_deg", c.field_of_view_deg);
}

template <class Io>
void describe(Io& io, FrameSettings& f) {
  std::array<int, 2> size_px{f.width_px, f.height_px};
  io.field("every_s", f.every_s);
  io.field("size_px", size_px);
  io.field("camera", f.camera);
  f.width_px = size_px[0];
  f.height_px = size_px[1];
}

template <class Io>
void describe(Io& io, RecordSettings& r) {
  io.field("snapshots_every_s", r.snapshots_every_s);
  io.field("frames", r.frames);
  io.field("force_inputs", r.force_inputs);
}

template <class Io>
void describe(Io& io, MeasureSettings& m) {
  io.field("sample_spacing_m", m.sample_spacing_m);
  io.field("certify", m.certify);
}

template <class Io>
void describe(Io& io, Expectation& e) {
  io.required("quantity", e.quantity);
  io.field("pipeline", e.pipeline);
  io.field("value", e.value);
  io.field("tolerance", e.tolerance);
  io.field("min", e.min);
  io.field("max", e.max);
  io.choice("contact", e.contact, catalog().expected_contacts);
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
