#pragma once

#include <array>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// One side of a tetrahedron.
struct TetrahedronFace {
  Face sorted{};         ///< its vertices, least first
  Face outward{};        ///< counter-clockwise seen from outside a tetrahedron of positive volume
  bool forward = false;  ///< `outward` runs through them as `sorted` does, turned or not
  int tetrahedron = 0;

  bool sameFace(const TetrahedronFace& other) const { return sorted == other.sorted; }
};

/// The sides of all tetrahedra, those with the same corners next to each other, in the order of their
/// tetrahedra. All vertices must exist, with numbers below `vertices`; tetrahedra that name one twice have no
/// sides.
std::vector<TetrahedronFace> tetrahedronFaces(const std::vector<Tetrahedron>& tetrahedra,
                                              std::size_t vertices);

/// Calls visit(first, last) for the uses of each face.
template <class Visit>
void forEachFace(const std::vector<TetrahedronFace>& uses, Visit visit) {
  for (auto first = uses.begin(); first != uses.end();) {
    auto last = first;
    while (last != uses.end() && last->sameFace(*first)) ++last;
    visit(first, last);
    first = last;
  }
}

/// True when the tetrahedron names a vertex twice.
bool repeatsCorner(const Tetrahedron& tetrahedron);

}  // namespace fissure
