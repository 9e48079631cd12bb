#include "mesh/tetrahedron_faces.h"

#include <algorithm>
#include <tuple>

namespace fissure {
namespace {

TetrahedronFace sideOf(const Face& outward, int tetrahedron) {
  Face sorted = outward;
  std::sort(sorted.begin(), sorted.end());
  const auto least =
      static_cast<std::size_t>(std::find(outward.begin(), outward.end(), sorted[0]) - outward.begin());
  return {sorted, outward, outward[(least + 1) % 3] == sorted[1], tetrahedron};
}

}  // namespace

bool repeatsCorner(const Tetrahedron& tetrahedron) {
  const auto [a, b, c, d] = tetrahedron;
  return a == b || a == c || a == d || b == c || b == d || c == d;
}

std::vector<TetrahedronFace> tetrahedronFaces(const std::vector<Tetrahedron>& tetrahedra,
                                              std::size_t vertices) {
  // Placed by their least vertex first: what is left to sort is a handful each.
  std::vector<std::size_t> first(vertices + 1, 0);
  const auto forEachSide = [&](auto visit) {
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
      if (repeatsCorner(tetrahedra[t])) continue;
      const auto [a, b, c, d] = tetrahedra[t];
      for (const Face& side : {Face{a, c, b}, Face{a, b, d}, Face{b, c, d}, Face{a, d, c}})
        visit(side, static_cast<int>(t));
    }
  };
  const auto least = [](const Face& side) {
    return static_cast<std::size_t>(*std::min_element(side.begin(), side.end()));
  };
  forEachSide([&](const Face& side, int) { ++first[least(side) + 1]; });
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  std::vector<TetrahedronFace> uses(first[vertices]);
  std::vector<std::size_t> next = first;
  forEachSide([&](const Face& side, int t) { uses[next[least(side)]++] = sideOf(side, t); });
  for (std::size_t v = 0; v < vertices; ++v)
    std::sort(uses.begin() + static_cast<std::ptrdiff_t>(first[v]),
              uses.begin() + static_cast<std::ptrdiff_t>(first[v + 1]),
              [](const TetrahedronFace& a, const TetrahedronFace& b) {
                return std::tie(a.sorted, a.tetrahedron) < std::tie(b.sorted, b.tetrahedron);
              });
  return uses;
}

}  // namespace fissure
