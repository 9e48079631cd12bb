#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/vertex_sides.h"

namespace fissure {

/// Tissue vertices that stick to a box tool from the step in which they reach it. It is the reference for the
/// tissue's own part of a force curve, without contacts that come and go. One object belongs to one run.
class HeldVertices {
 public:
  /// margins_m: [body].
  HeldVertices(const Scene& scene, const std::vector<double>& margins_m)
      : sides_(scene, margins_m), held_(scene.vertexCount()) {}

  /// A vertex that is held, and its tool.
  struct Held {
    int tool = 0;
    Vec3 position_m, normal;  ///< tool frame; the normal is unit, from the tool into the tissue
  };

  /// Holds the vertices that reach a tool at the step's positions_m, a margin in front of the tool.
  /// inverse_masses: [vertex] 1/kg; fixed vertices (0) are never held.
  void hold(const StepView& step, std::span<const double> inverse_masses);

  /// [vertex] empty: it is free.
  const std::vector<std::optional<Held>>& vertices() const { return held_; }

 private:
  VertexSides sides_;
  std::vector<std::optional<Held>> held_;
  std::vector<ContactConstraint> reached_;
};

}  // namespace fissure
