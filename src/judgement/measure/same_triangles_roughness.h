#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/state.h"

namespace fissure {

/// Roughness of each law's force over a constant set of triangles (measure/METHOD.md 5): RMS of the second
/// difference over the RMS of the whole force, where the difference at each step is taken over the triangles
/// that collide in it and in both steps before. It is Roughness without the effect of triangles that enter or
/// leave the law's sum. The triangles of three steps are kept.
class SameTrianglesRoughness {
 public:
  explicit SameTrianglesRoughness(std::size_t laws) : sums_(laws) {}

  /// Takes the state of the next step.
  void add(const State& state);
  /// The roughness of a law's force; NaN as for Roughness::value().
  double value(std::size_t law) const;

 private:
  struct Step {
    std::vector<int> triangles;  ///< ascending
    std::vector<Vec3> forces_N;  ///< [triangle x number of laws + law]
  };
  struct Sums {
    double force_squared = 0, difference_squared = 0;
    std::array<Vec3, 3> shared_N;  ///< [step] force of the triangles that collide in all three steps
  };
  void addShared();

  std::array<Step, 3> steps_;  ///< latest first
  std::vector<Sums> sums_;     ///< one per law
  long long count_ = 0;
};

}  // namespace fissure
