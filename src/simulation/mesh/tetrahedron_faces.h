#pragma once

#include <array>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// One side of a tetrahedron.
struct TetrahedronFace {
  Face sorted{};         ///< its vertices, ascending
  Face outward{};        ///< counter-clockwise seen from outside a tetrahedron of positive volume
  bool forward = false;  ///< `outward` is an even permutation of `sorted`
  int tetrahedron = 0;

  bool sameFace(const TetrahedronFace& other) const { return sorted == other.sorted; }
};

/// The sides of all tetrahedra, grouped by their corners and within a group in the order of their tetrahedra.
/// All indices must be below `vertices`, their number; tetrahedra that name one twice have no sides.
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
