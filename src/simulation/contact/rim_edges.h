#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/step_view.h"

namespace fissure {

/// Contacts where a tissue edge crosses the rim of a box tool's large faces between its nodes
/// (contact/METHOD.md 7; not in the paper). Such a crease cuts into the tool although no tissue vertex does
/// and no node ray hits it. The crossing point is held in front of the large face from which it came. One
/// object belongs to one run.
class RimEdges {
 public:
  /// margins_m: [body]. max_displacement_m: cap on the displacement of a crossing in a step, beyond the
  /// approach in that step.
  RimEdges(const Scene& scene, const std::vector<double>& margins_m, double max_displacement_m);

  /// Appends one constraint per crossing. put_inside: [tool] 1: the tool is ignored; empty: no tool is.
  void find(const StepView& step, std::span<const std::uint8_t> put_inside,
            std::vector<ContactConstraint>& constraints);

 private:
  struct Box {
    int tool = 0;
    Vec3 half_m;
    int thin_axis = 0;  ///< the axis across the large faces
  };
  struct Edge {
    std::array<int, 2> vertices{};
    double margin_m = 0;
  };
  void findOn(const Box& box, const ToolState& now, std::vector<ContactConstraint>& constraints) const;

  double max_displacement_m_;
  std::vector<Box> boxes_;
  std::vector<Edge> edges_;
  /// Tissue vertices in the frame of one box, now and at the start of the step.
  std::vector<Vec3> local_m_, local_before_m_;
};

}  // namespace fissure
