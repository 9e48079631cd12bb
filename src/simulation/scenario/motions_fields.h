#pragma once

#include "scenario/catalog.h"
#include "scenario/clamps_fields.h"
#include "scenario/motions.h"

namespace fissure {

// The keys of a tool's motion (scenario/fields.h says how keys are described).

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
void describe(Io& io, RowFilter& f) {
  io.required("column", f.column);
  io.required("equals", f.equals);
}

template <class Io>
void describe(Io& io, ReplayMotion& m) {
  io.required("file", m.file);
  io.choice("layout", m.layout, catalog().log_layouts);
  const bool rows = m.layout == LogLayout::rows;
  io.fieldIf(rows, "layout rows", "time_column", m.time_column);
  io.choiceIf(rows, "layout rows", "time_unit", m.time_unit, catalog().time_units);
  io.field("rate_hz", m.rate_hz);
  io.fieldIf(rows, "layout rows", "frame_column", m.frame_column);
  io.fieldIf(rows, "layout rows", "where", m.where);
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
  io.field("jump_speed_m_s", m.jump_speed_m_s);
}

}  // namespace fissure
