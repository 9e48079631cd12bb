#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/record.h"
#include "base/scene.h"
#include "base/state.h"

namespace fissure {

/// Finds steps in which tissue is unsound for other reasons than a tool (measure/METHOD.md 2). A step is
/// unsound when
///   a body that no tool has met yet has inverted triangles,
///   more than half of a body's triangles are inverted while no tool meets it, or
///   a body is kExplodedExtent times as long as at rest, whoever pulls.
class Soundness {
 public:
  explicit Soundness(const Scene& scene);

  /// The state of a body in one step.
  struct BodyStep {
    long long inverted = 0;       ///< triangles that do not bound it from outside
    bool touched = false;         ///< a tool touches it in this step
    bool touched_before = false;  ///< a tool touches it now or has touched it before
  };
  /// Takes the next step. Positions must be finite; `bodies` are in the scene's order.
  void add(const State& state, const std::vector<BodyStep>& bodies);
  /// Appends unsound_steps and, where there are any, first_unsound_step and unsound_tissue, a text with the
  /// body and its problem.
  void summarize(Summary& summary) const;

 private:
  struct Body {
    std::string name;
    std::size_t first_vertex = 0, vertex_count = 0;
    long long triangles = 0;
    double extent_m = 0;  // longest side of the bounding box at rest
  };
  std::string problemOf(const Body& body, const BodyStep& step, const State& state) const;

  std::vector<Body> bodies_;
  bool sampled_ = false;
  long long unsound_steps_ = 0;
  std::optional<long long> first_step_;
  std::string first_problem_;
};

/// Ratio of the longest side of a body's bounding box to that at rest, from which on it counts as exploded.
inline constexpr double kExplodedExtent = 3;

}  // namespace fissure
