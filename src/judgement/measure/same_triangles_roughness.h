#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/state.h"

namespace fissure {

/// Roughness of each law's force at a constant set of triangles: RMS of the second difference, which at each
/// step is taken over the triangles that collide in it and in both steps before it, over the RMS of the whole
/// force. What is left of Roughness without triangles that enter or leave the law's sum; the same where none
/// does. Keeps the triangles of three steps.
class SameTrianglesRoughness {
 public:
  explicit SameTrianglesRoughness(std::size_t laws) : sums_(laws) {}

  void add(const State& state);
  /// Missing as Roughness's.
  double value(std::size_t law) const;

 private:
  struct Step {
    std::vector<int> triangles;  ///< ascending
    std::vector<Vec3> forces_N;  ///< triangle x number of laws + law
  };
  struct Sums {
    double force_squared = 0, difference_squared = 0;
    std::array<Vec3, 3> shared_N;  ///< of the triangles in all three steps, in one step each
  };
  void addShared();

  std::array<Step, 3> steps_;  ///< the last one first
  std::vector<Sums> sums_;     ///< one a law
  long long count_ = 0;
};

}  // namespace fissure
