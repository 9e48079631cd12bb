#pragma once

#include <algorithm>
#include <cmath>

#include "base/geometry.h"
#include "scenario/choice_text.h"
#include "scenario/key.h"

namespace fissure {

/// Two lobes of a half ellipsoid on its flat side, parted by a slit along z and joined below it: a fissure.
/// The origin is the middle of the flat side, y up. Mirror-symmetric in x = 0, to the last bit.
struct LobesShape {
  static constexpr ShapeText text{"lobes", "half an ellipsoid parted by a slit, mirror-symmetric: a fissure",
                                  "as a body's"};

  Vec3 size_m = {0.08, 0.04, 0.08};
  double slit_depth_m = 0.028;
  double slit_width_m = 0.001;
  double edge_m = 0.006;

  /// Numbers of cells of the mesh.
  struct Cells {
    double across = 0;      ///< in x, of one lobe
    double joined = 0;      ///< in y, below the slit's floor
    double parted = 0;      ///< in y, above the slit's floor
    double half_along = 0;  ///< in z, on each side of z = 0
  };
  Cells cells() const {
    const auto along = [this](double length_m) { return std::max(1.0, std::ceil(length_m / edge_m - 1e-9)); };
    return {along(size_m.x() / 2), along(size_m.y() - slit_depth_m), along(slit_depth_m),
            along(size_m.z() / 2)};
  }
  double triangles() const {
    const Cells n = cells();
    const double height = n.joined + n.parted;
    return 8 * (n.half_along * (2 * n.across + height + n.parted) + height * n.across);
  }
  double tetrahedra() const {
    const Cells n = cells();
    return 24 * n.across * (n.joined + n.parted) * n.half_along;
  }

  bool operator==(const LobesShape&) const = default;
};

template <class Io>
void describe(Io& io, LobesShape& s) {
  io.field(
      "size_m", s.size_m,
      Key("Size of the whole: across the slit (x), in height (y), along the slit (z).").above(0).required());
  io.field("slit_depth_m", s.slit_depth_m,
           Key("Depth of the slit in the middle, from the top; less than the height.").above(0).required());
  io.field("slit_width_m", s.slit_width_m,
           Key("Width of the slit at the top, less than half the size across; it closes towards the floor of "
               "the slit.")
               .above(0)
               .required());
  io.field("edge_m", s.edge_m,
           Key("Longest edge of the cells, two triangles each, of the upright block whose surface is bent "
               "into the ellipsoid.")
               .above(0)
               .required());
}

}  // namespace fissure
