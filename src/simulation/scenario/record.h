#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/geometry.h"
#include "scenario/catalog.h"
#include "scenario/key.h"
#include "scenario/measure_settings.h"

namespace fissure {

struct CameraSettings {
  Vec3 position_m = {0, 0.1, 0.2};
  Vec3 look_at_m = {0, 0, 0};
  Vec3 up = {0, 1, 0};
  double field_of_view_deg = 35;

  bool operator==(const CameraSettings&) const = default;
};

struct FrameSettings {
  double every_s = 0.05;
  int width_px = 640;
  int height_px = 480;
  std::optional<CameraSettings> camera;

  bool operator==(const FrameSettings&) const = default;
};

struct RecordSettings {
  std::optional<double> snapshots_every_s;
  std::optional<FrameSettings> frames;
  bool force_inputs = false;
  std::optional<int> every;  ///< steps per row

  bool operator==(const RecordSettings&) const = default;
};

/// Whether an expectation needs contact. By default an upper bound on depth, passing through or inversion
/// fails in a run in which a tool never touched tissue, because such a run proves nothing.
enum class ExpectedContact {
  any,  ///< bounds can hold without contact
};

/// A requirement on a value in a run's summary, checked after the run: a value within a tolerance, or bounds.
struct Expectation {
  std::optional<std::string> pipeline;
  std::string quantity;
  std::optional<double> value;
  std::optional<double> tolerance;
  std::optional<double> min;
  std::optional<double> max;
  std::optional<ExpectedContact> contact;

  bool operator==(const Expectation&) const = default;
};

/// Number of steps between two rows of the record.
inline int stepsPerRow(const RecordSettings& record, const MeasureSettings& measure) {
  return record.every.value_or(stepsPerMeasurement(measure));
}

template <class Io>
void describe(Io& io, CameraSettings& c) {
  io.field("position_m", c.position_m, Key("Where the camera is, in the scene's frame."));
  io.field("look_at_m", c.look_at_m, Key("The point in the middle of the picture, in the scene's frame."));
  io.field("up", c.up, Key("A direction across the view that points up in the picture.").noUnit());
  io.field("field_of_view_deg", c.field_of_view_deg, Key("Vertical field of view.").between(1, 150));
}

template <class Io>
void describe(Io& io, FrameSettings& f) {
  std::array<int, 2> size_px{f.width_px, f.height_px};
  io.field("every_s", f.every_s, Key("Time between two pictures, at least one step.").above(0));
  io.field("size_px", size_px, Key("Width and height of the pictures.").between(16, 4096));
  io.field("camera", f.camera,
           Key("Where the scene is seen from.")
               .otherwise("the whole first state in view, seen from the front, above"));
  f.width_px = size_px[0];
  f.height_px = size_px[1];
}

template <class Io>
void describe(Io& io, RecordSettings& r) {
  io.field(
      "every", r.every,
      Key("Number of steps between two rows of the series; the last step has a row too. The summary is of "
          "all steps all the same.")
          .count(1, 1000000)
          .otherwise("measure.every"));
  io.field("snapshots_every_s", r.snapshots_every_s,
           Key("Time between two snapshots of all vertex positions, at least one step; pictures, videos and "
               "ParaView are made from them.")
               .above(0)
               .otherwise("no snapshots"));
  io.field(
      "frames", r.frames,
      Key("Pictures that are drawn during the run.").otherwise("no pictures, and no renderer is loaded"));
  io.field("force_inputs", r.force_inputs,
           Key("Whether what the force laws see of each colliding triangle is kept for each step, so that "
               "other laws can be evaluated without simulating again; needs a force law."));
}

template <class Io>
void describe(Io& io, Expectation& e) {
  const char* const bounds = "`value` with `tolerance`, `min` or `max` is required";
  io.field("quantity", e.quantity,
           Key("Name of a value of the run's summary (`fissure info` shows them), no time of the machine.")
               .required());
  io.field("pipeline", e.pipeline, Key("Name of the run that is checked.").otherwise("every run"));
  io.field("value", e.value,
           Key("The value that is expected, with `tolerance`.")
               .unit("the unit of the quantity")
               .otherwise(bounds));
  io.field("tolerance", e.tolerance,
           Key("Largest difference to `value`.")
               .unit("the unit of the quantity")
               .atLeast(0)
               .otherwise("required with `value`"));
  io.field("min", e.min,
           Key("Smallest value that is good.").unit("the unit of the quantity").otherwise(bounds));
  io.field("max", e.max,
           Key("Largest value that is good.").unit("the unit of the quantity").otherwise(bounds));
  io.field(
      "contact", e.contact,
      Key("Whether bounds hold in a run in which a tool never touched tissue.")
          .oneOf(catalog().expected_contacts)
          .otherwise("an upper bound on depth, passing through or inversion does not hold without contact"));
}

}  // namespace fissure
