#include "mesh/edges.h"

#include <algorithm>
#include <tuple>

namespace fissure {

bool repeatsCorner(const Face& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

std::vector<EdgeUse> edgeUses(const std::vector<Face>& faces) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (repeatsCorner(faces[f])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = faces[f][k], to = faces[f][(k + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<int>(f)});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  return uses;
}

}  // namespace fissure
