#include "mesh/hexahedron.h"

#include <utility>

namespace fissure {

void addKuhnTetrahedra(const std::array<int, 8>& corners, unsigned start,
                       std::vector<Tetrahedron>& tetrahedra) {
  struct Path {
    unsigned first, second;  ///< the axes of the first two edges, as bits
    bool even;               ///< whether x, y, z in this order are an even permutation
  };
  constexpr std::array<Path, 6> paths = {
      {{1, 2, true}, {2, 4, true}, {4, 1, true}, {2, 1, false}, {1, 4, false}, {4, 2, false}}};
  const bool mirrored = ((start ^ (start >> 1) ^ (start >> 2)) & 1U) != 0;
  for (const auto& [first, second, even] : paths) {
    Tetrahedron made = {corners[start], corners[start ^ first], corners[start ^ first ^ second],
                        corners[start ^ 7U]};
    if (even == mirrored) std::swap(made[1], made[2]);
    tetrahedra.push_back(made);
  }
}

}  // namespace fissure
