#pragma once

#include "scenario/catalog.h"
#include "scenario/shapes.h"

namespace fissure {

// The keys of a shape (scenario/fields.h says how keys are described).

template <class Io>
void describe(Io& io, SphereShape& s) {
  io.required("radius_m", s.radius_m);
  io.field("subdivisions", s.subdivisions);
}

template <class Io>
void describe(Io& io, BoxShape& s) {
  io.required("size_m", s.size_m);
  io.field("cells", s.cells);
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
void describe(Io& io, TetrahedraShape& s) {
  io.required("file", s.file);
  io.requiredChoice("unit", s.unit, catalog().length_units);
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
