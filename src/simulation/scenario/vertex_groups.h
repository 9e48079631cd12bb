#pragma once

#include <optional>
#include <string>

#include "scenario/regions.h"

namespace fissure {

/// A region, in the scene frame at time zero, whose vertices never move. Exactly one of the two is given.
struct FixedRegion {
  std::optional<double> below_m;
  std::optional<BoxRegion> box;

  bool operator==(const FixedRegion&) const = default;
};

/// Vertices of a body whose mean displacement is recorded, for instance to see how far an opening was opened.
struct GaugeSettings {
  std::string name;
  BoxRegion box;

  bool operator==(const GaugeSettings&) const = default;
};

template <class Io>
void describe(Io& io, FixedRegion& r) {
  io.field(
      "below_m", r.below_m,
      Key("Vertices at this height (y) or below it are fixed. Exactly one of `below_m` and `box` is given.")
          .otherwise("`box` says where"));
  io.field(
      "box", r.box,
      Key("Vertices inside this box, in the scene's frame, are fixed.").otherwise("`below_m` says where"));
}

template <class Io>
void describe(Io& io, GaugeSettings& g) {
  io.field("name", g.name,
           Key("Name of the gauge, once in the scenario; it is part of the names of its results.")
               .itemName()
               .required());
  io.field("box", g.box,
           Key("The vertices inside this box at time zero are the gauge: at least one, in the scene's frame, "
               "where the body is placed.")
               .required());
}

}  // namespace fissure
