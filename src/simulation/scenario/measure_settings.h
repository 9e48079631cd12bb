#pragma once

#include <optional>

#include "scenario/key.h"

namespace fissure {

struct MeasureSettings {
  std::optional<double> sample_spacing_m;
  bool certify = false;
  std::optional<int> every;  ///< steps per measurement

  bool operator==(const MeasureSettings&) const = default;
};

/// Number of steps between two measurements of depth.
inline int stepsPerMeasurement(const MeasureSettings& measure) {
  return measure.every.value_or(1);
}

template <class Io>
void describe(Io& io, MeasureSettings& m) {
  io.field(
      "every", m.every,
      Key("Number of steps between two looks at depth, inversion and certificate, which may cost more than "
          "the step; the last step is looked at too. What happens in between is not seen, and the run's "
          "verdict says so. record.every must be a multiple of it.")
          .count(1, 1000000)
          .otherwise("1"));
  io.field(
      "sample_spacing_m", m.sample_spacing_m,
      Key("Distance between the samples of a tool's surface on which penetration is measured.")
          .above(0)
          .otherwise(
              "fine enough for the thinnest tool and the finest tissue edge, within limits of their number"));
  io.field("certify", m.certify,
           Key("Whether the end of each step is proved free of overlap between tools and tissue, by "
               "continuous collision detection over all their triangles; costs up to a fifth of a step."));
}

}  // namespace fissure
