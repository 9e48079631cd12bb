#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/vertex_sides.h"

namespace fissure {

/// Tissue vertices that stick to a box tool from the step in which they reach it: the reference for what is
/// the tissue's own in a force curve. One object belongs to one run.
class HeldVertices {
 public:
  /// margins_m: one a body.
  HeldVertices(const Scene& scene, const std::vector<double>& margins_m)
      : sides_(scene, margins_m), held_(scene.vertexCount()) {}

  struct Held {
    int tool = 0;
    Vec3 position_m, normal;  ///< tool frame; the normal is unit, from the tool into the tissue
  };

  /// Holds what reaches a tool by positions_m, a margin in front of it. inverse_masses: one per vertex in
  /// 1/kg, 0: fixed, never held.
  void hold(const StepView& step, std::span<const double> inverse_masses);

  /// One per vertex; empty: it is free.
  const std::vector<std::optional<Held>>& vertices() const { return held_; }

 private:
  VertexSides sides_;
  std::vector<std::optional<Held>> held_;
  std::vector<ContactConstraint> reached_;
};

}  // namespace fissure
