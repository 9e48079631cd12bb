#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/step_view.h"

namespace fissure {

/// Beyond the paper: contacts where an edge of the tissue crosses the rim of a box tool's large faces in
/// between its nodes. Such a crease cuts into the tool though no tissue vertex does and no node sees it. The
/// crossing point is held in front of the large face it came from. Where a tool was put into tissue, deeper
/// than contacts leave it, edges are free: the nodes push the tool out. One object belongs to one run.
class RimEdges {
 public:
  /// margins_m: one a body. max_displacement_m: how far a crossing may be pushed in a step beyond its own
  /// approach, as NodeContactSettings says.
  RimEdges(const Scene& scene, const std::vector<double>& margins_m, double max_displacement_m);

  /// Appends one constraint for each crossing. put_inside: as VertexSides::find has it.
  void find(const StepView& step, std::span<const std::uint8_t> put_inside,
            std::vector<ContactConstraint>& constraints);

 private:
  struct Box {
    int tool = 0;
    Vec3 half_m;
    int thin_axis = 0;  ///< across the large faces
  };
  struct Edge {
    std::array<int, 2> vertices{};
    double margin_m = 0;
  };
  void findOn(const Box& box, const ToolState& now, std::vector<ContactConstraint>& constraints) const;

  double max_displacement_m_;
  std::vector<Box> boxes_;
  std::vector<Edge> edges_;
  std::vector<Vec3> local_m_, local_before_m_;  ///< the tissue in one box's frame, now and before
};

}  // namespace fissure
