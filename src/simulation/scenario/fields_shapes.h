#pragma once

#include <array>

#include "scenario/catalog.h"
#include "scenario/scenario.h"

namespace fissure {

// The keys of every map of a scenario file, once, in the order in which they are written. MapReader and
// MapWriter are the two kinds of Io: what one writes, the other reads.
//   io.required(key, value)            must be in the file
//   io.field(key, value)               may be left out: the struct's default, or no value, stands
//   io.fieldIf(applies, when, key, value)   has a meaning only if `applies`; an error elsewhere
//   io.choice / io.requiredChoice      a name from a table of the catalog
//   io.choices(key, values, table)     a list of such names, which may be left out
//   io.tagged(key, value, table)       a map whose `type` names the alternative
//   io.whileReading(fill)              sets the defaults of keys that follow by those before
//   io.nameOr(key, value, other_key)   a name that may be left out: then what `other_key` says

template <class Io>
void describe(Io& io, SphereShape& s) {
  io.required("radius_m", s.radius_m);
  io.field("subdivisions", s.subdivisions);
}

template <class Io>
void describe(Io& io, BoxShape& s) {
  io.required("size_m", s.size_m);
}

template <class Io>
void describe(Io& io, TrianglesShape& s) {
  io.required("vertices_m", s.vertices_m);
  io.required("faces", s.faces);
}

template <class Io>
void describe(Io& io, FileShape& s) {
  io.required("file", s.file);
  io.requiredChoice("unit", s.unit, catalog().length_units);
  io.field("weld_tolerance_m", s.weld_tolerance_m);
  io.choices("repairs", s.repairs, catalog().mesh_repairs);
  io.field("max_edge_m", s.max_edge_m);
}

template <class Io>
void describe(Io& io, CapsuleShape& s) {
  io.required("radius_m", s.radius_m);
  io.required("length_m", s.length_m);
  io.field("subdivisions", s.subdivisions);
}

template <class Io>
void describe(Io& io, LobesShape& s) {
  io.required("size_m", s.size_m);
  io.required("slit_depth_m", s.slit_depth_m);
  io.required("slit_width_m", s.slit_width_m);
  io.required("edge_m", s.edge_m);
}

}  // namespace fissure
