#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/step_view.h"

namespace fissure {

/// Contacts for tissue vertices that slip between the nodes of a box tool (contact/METHOD.md 7; not in the
/// paper). Each vertex remembers the face of the box from which it came: a vertex within a margin of the box
/// is held in front of that face, and one that crossed the box within a step is held in front of the face
/// through which it entered. A vertex that starts inside the box has no side and gets no contact; one that
/// starts within the margin is on the nearest side. One object belongs to one run.
class VertexSides {
 public:
  /// margins_m: [body].
  VertexSides(const Scene& scene, const std::vector<double>& margins_m);

  /// Appends one constraint for each vertex that must be held in front of its side. put_inside: [tool] 1: the
  /// tool is ignored; empty: no tool is.
  void find(const StepView& step, std::span<const std::uint8_t> put_inside,
            std::vector<ContactConstraint>& constraints);

 private:
  static constexpr std::int8_t kNoSide = -1;

  struct Box {
    int tool = 0;
    Vec3 half_m;
    std::vector<std::int8_t> sides;  ///< [vertex] 2 x axis + (0: positive, 1: negative face), or kNoSide
  };

  std::vector<Box> boxes_;
  std::vector<double> margins_m_;  ///< [vertex]
};

}  // namespace fissure
