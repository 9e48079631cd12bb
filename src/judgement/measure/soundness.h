#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/record.h"
#include "base/scene.h"
#include "base/state.h"

namespace fissure {

/// Looks for tissue that is unsound by itself, without a tool's doing. A step is unsound when
///   a body that no tool has met yet has inverted triangles,
///   more than half of a body's triangles are inverted while no tool meets it, or
///   a body is kExplodedExtent times as long as at rest, whoever pulls.
class Soundness {
 public:
  explicit Soundness(const Scene& scene);

  /// What a step knows of a body.
  struct BodyStep {
    long long inverted = 0;       ///< triangles that do not bound it from outside
    bool touched = false;         ///< a tool meets it in this step
    bool touched_before = false;  ///< or has met it in one before
  };
  /// The next step; finite positions, `bodies` in the scene's order.
  void add(const State& state, const std::vector<BodyStep>& bodies);
  /// Scalars unsound_steps and, where there are any, first_unsound_step and unsound_tissue: the body, and
  /// what is wrong with it.
  void summarize(Summary& summary) const;

 private:
  struct Body {
    std::string name;
    std::size_t first_vertex = 0, vertex_count = 0;
    long long triangles = 0;
    double extent_m = 0;  // at rest
  };
  std::string problemOf(const Body& body, const BodyStep& step, const State& state) const;

  std::vector<Body> bodies_;
  bool sampled_ = false;
  long long unsound_steps_ = 0;
  std::optional<long long> first_step_;
  std::string first_problem_;
};

/// Longest side of a body's bounding box over that at rest, from which on it has exploded.
inline constexpr double kExplodedExtent = 3;

}  // namespace fissure
