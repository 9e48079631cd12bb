#pragma once

#include "scenario/catalog.h"
#include "scenario/clamps.h"
#include "scenario/shapes_fields.h"

namespace fissure {

// The keys of a clamp (scenario/fields.h says how keys are described).

template <class Io>
void describe(Io& io, ClampPart& p) {
  io.tagged("shape", p.shape, catalog().tool_shapes);
  io.field("position_m", p.position_m);
  io.field("orientation", p.orientation);
}

template <class Io>
void describe(Io& io, ClampSettings& c) {
  io.requiredChoice("opening", c.opening, catalog().clamp_openings);
  if (c.opening == ClampOpening::hinged)
    io.required("hinge_height_m", c.hinge_height_m);
  else
    io.fieldIf(false, "opening hinged", "hinge_height_m", c.hinge_height_m);
  io.required("jaw_position_m", c.jaw_position_m);
  io.field("jaw_orientation", c.jaw_orientation);
  io.field("left_jaw", c.left_jaw);
  io.field("handle", c.handle);
}

template <class Io>
void describe(Io& io, DeviceOpening& o) {
  io.requiredChoice("axis", o.axis, catalog().device_axes, "an axis of the device: x, y or z");
  io.required("closed_device_m", o.closed_device_m);
  io.required("open_device_m", o.open_device_m);
  io.field("open_m", o.open_m);
  io.field("open_deg", o.open_deg);
}

}  // namespace fissure
