#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/half_space.h"
#include "contact/step_view.h"
#include "contact/swept_obstacle.h"

namespace fissure {

/// Counts of truncation over the run so far.
struct TruncationCounts {
  long long steps = 0;          ///< steps in which tissue was stopped
  long long vertices = 0;       ///< stopped vertices, summed over these steps
  long long no_room_steps = 0;  ///< steps after which tissue may overlap a tool
};

/// Truncation, the last resort of swept contact (contact/METHOD.md 9). Tissue that still crosses a tool after
/// all rounds is stopped on its path, at worst at its position at the start of the step in the tool's frame,
/// so that it rides with the tool. Vertices that end below the ground are put on it. Passes over the ground
/// and all tools are repeated until nothing more is stopped. Where there is no room, a tool that is a body is
/// first taken back to where it was when the step began, and keeps its velocity. Then fixed vertices come
/// first (they never move), then the ground, then the tools in the scenario's order; where tissue may overlap
/// a tool in the end, the step is counted as one without room.
class PathTruncation {
 public:
  /// `single_precision`: the engine's precision; positions are then rounded to it before they are checked.
  PathTruncation(int vertex_count, const std::optional<HalfSpace>& ground, bool single_precision)
      : ground_(ground),
        single_precision_(single_precision),
        stopped_by_(vertex_count, kNone),
        rides_(vertex_count) {}

  /// Moves the step's positions_m, and at worst its tool_bodies, until nothing crosses. A stopped vertex gets
  /// the tool's velocity: its `motion_m` ([vertex], as in ContactImpulses) becomes the tool's displacement
  /// minus the vertex's own displacement before contacts, `way_m`. With a tool that is a body both get their
  /// common velocity, so that their momentum is conserved. A vertex that is put on the ground loses its
  /// velocity into the ground. inverse_masses: [vertex] 1/kg, 0: fixed.
  void apply(std::span<SweptObstacle> obstacles, std::span<const double> inverse_masses, const StepView& step,
             std::span<const Vec3> way_m, std::span<Vec3> motion_m);

  /// Impulse that the last apply() gave tissue stopped at tools, times the time step, kg m: the sum over
  /// vertices, each multiplied by its factor (`factors`: [vertex]).
  Vec3 total(std::span<const double> factors) const;
  /// The same for one tool, or for the ground with kGround.
  Vec3 ofTool(int tool, std::span<const double> factors) const;
  /// Work of the tools on stopped tissue times the square of the time step, kg m2, as in ContactImpulses.
  double toolWork_kg_m2() const;
  /// Forgets the last apply().
  void clear();

  /// Whether the last apply left tissue that may overlap a tool.
  bool leftOverlap() const { return left_overlap_; }
  const TruncationCounts& counts() const { return counts_; }

 private:
  static constexpr int kNone = -2, kByGround = -1;  ///< values of stopped_by_
  struct Stopped {
    int vertex = 0, tool = 0;  ///< tool index or kGround
    Vec3 impulse_kg_m;
    Vec3 tool_step_m = Vec3::Zero();  ///< displacement of the tool there in the step; zero for the ground
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
  std::vector<int> stopped_by_;  ///< [vertex] index of the last obstacle that stopped it, kByGround or kNone
  std::vector<std::uint8_t> rides_;  ///< [vertex] 1: it stays where the obstacle that stopped it has put it
  std::vector<SweptPair> crossings_;
  std::vector<Stopped> stopped_;
  std::vector<Vec3> start_m_;  ///< positions before truncation; only where tools are bodies
  bool only_ride_ = false;     ///< paths are no longer shortened: stopped vertices ride with their tool
  bool left_overlap_ = false;
};

}  // namespace fissure
