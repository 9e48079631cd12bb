#pragma once

#include <vector>

#include "base/geometry.h"

namespace fissure {

/// One side of a triangle.
struct EdgeUse {
  int low = 0, high = 0;  ///< its vertices, with low < high
  bool forward = false;   ///< the triangle runs through it from low to high
  int face = 0;

  bool sameEdge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// The sides of all triangles, grouped by edge and within a group in the order of their triangles. Triangles
/// that name a vertex twice are left out.
std::vector<EdgeUse> edgeUses(const std::vector<Face>& faces);

/// Calls visit(first, last) for the uses of each edge.
template <class Visit>
void forEachEdge(const std::vector<EdgeUse>& uses, Visit visit) {
  for (auto first = uses.begin(); first != uses.end();) {
    auto last = first;
    while (last != uses.end() && last->sameEdge(*first)) ++last;
    visit(first, last);
    first = last;
  }
}

/// True when the triangle names a vertex twice.
bool repeatsCorner(const Face& face);

}  // namespace fissure
