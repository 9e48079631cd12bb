#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/step_view.h"

namespace fissure {

/// Beyond the paper: contacts for tissue vertices that slip in between the nodes of a box tool. Each vertex
/// remembers from which face of the box it came; a vertex within a margin of the box is held in front of that
/// face, and one that crossed the box within a step in front of the face it entered through. A vertex that
/// starts inside has no side and gets no contact; one that starts within the margin is on the nearest side.
/// One object belongs to one run.
class VertexSides {
 public:
  /// margins_m: one a body.
  VertexSides(const Scene& scene, const std::vector<double>& margins_m);

  /// Appends one constraint for each vertex that must be held in front of its side. put_inside: one per tool,
  /// 1: as if the tool were not there; empty: every tool counts.
  void find(const StepView& step, std::span<const std::uint8_t> put_inside,
            std::vector<ContactConstraint>& constraints);

 private:
  static constexpr std::int8_t kNoSide = -1;

  struct Box {
    int tool = 0;
    Vec3 half_m;
    std::vector<std::int8_t> sides;  ///< per vertex: 2 x axis + (0: positive, 1: negative face); kNoSide
  };

  std::vector<Box> boxes_;
  std::vector<double> margins_m_;  ///< per vertex
};

}  // namespace fissure
