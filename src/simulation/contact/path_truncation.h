#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/half_space.h"
#include "contact/step_view.h"
#include "contact/swept_obstacle.h"

namespace fissure {

/// What truncation did so far.
struct TruncationCounts {
  long long steps = 0;          ///< in which it stopped tissue
  long long vertices = 0;       ///< stopped, over these steps
  long long no_room_steps = 0;  ///< after which tissue may overlap a tool
};

/// The last resort of swept contact (METHOD section 9): tissue that still crosses a tool after all rounds is
/// stopped on its path before that, at worst where it was when the step began in the tool's frame: it then
/// rides with the tool. What ends below the ground is put on it. Every pass stops more, and looks at the
/// ground and all tools again. Where there is no room, fixed vertices never move, what else is tissue stays
/// above the ground, and the first tool in the scenario's order stays free of it; the step counts as one
/// without room where tissue may then overlap a tool. Before that a tool that is a body is taken back to
/// where it was when the step began, and keeps its velocity.
class PathTruncation {
 public:
  /// `single_precision`: of the engine; positions are rounded to it before they are checked.
  PathTruncation(int vertex_count, const std::optional<HalfSpace>& ground, bool single_precision)
      : ground_(ground),
        single_precision_(single_precision),
        stopped_by_(vertex_count, kNone),
        rides_(vertex_count) {}

  /// Moves the step's positions_m, at worst its tool_bodies too, until nothing crosses. A stopped vertex
  /// takes the tool's velocity: its share of `motion_m` (one a vertex, as ContactImpulses has it) becomes the
  /// tool's way less the vertex's own, `way_m`, before its contacts; with a tool that is a body it takes
  /// their common velocity, and what that gives the vertex the tool loses. One put on the ground loses what
  /// of its velocity leads into it. inverse_masses: one a vertex in 1/kg, 0: fixed.
  void apply(std::span<SweptObstacle> obstacles, std::span<const double> inverse_masses, const StepView& step,
             std::span<const Vec3> way_m, std::span<Vec3> motion_m);

  /// Of the last apply, times the time step: the impulse that stopping at tools gave the tissue, each
  /// vertex's times its factor. kg m.
  Vec3 total(std::span<const double> factors) const;
  /// The same of one tool, or with kGround of the ground.
  Vec3 ofTool(int tool, std::span<const double> factors) const;
  /// As ContactImpulses: the impulses times the displacements of the tools where vertices were stopped, kg
  /// m2.
  double toolWork_kg_m2() const;
  void clear();

  /// Whether the last apply left tissue that may overlap a tool.
  bool leftOverlap() const { return left_overlap_; }
  const TruncationCounts& counts() const { return counts_; }

 private:
  static constexpr int kNone = -2, kByGround = -1;  ///< of stopped_by_
  struct Stopped {
    int vertex = 0, tool = 0;  ///< or kGround
    Vec3 impulse_kg_m;
    Vec3 tool_step_m = Vec3::Zero();  ///< displacement of the tool there in the step; zero of the ground
  };

  void stopTissue(std::span<SweptObstacle> obstacles, std::span<const double> inverse_masses,
                  const StepView& step);
  static bool holdTools(const StepView& step);
  bool putOnGround(std::span<Vec3> positions_m, std::span<const double> inverse_masses);
  bool stop(const SweptObstacle& obstacle, int index, const SweptPair& pair, const StepView& step,
            std::span<const double> inverse_masses);

  TruncationCounts counts_;
  std::optional<HalfSpace> ground_;
  bool single_precision_;
  std::vector<int> stopped_by_;      ///< per vertex: index of the last obstacle that stopped it, or kByGround
  std::vector<std::uint8_t> rides_;  ///< per vertex, 1: what stopped it keeps it where it put it
  std::vector<SweptPair> crossings_;
  std::vector<Stopped> stopped_;
  std::vector<Vec3> start_m_;  ///< positions before tissue was stopped; only where tools are bodies
  bool only_ride_ = false;     ///< paths were shortened often enough
  bool left_overlap_ = false;
};

}  // namespace fissure
