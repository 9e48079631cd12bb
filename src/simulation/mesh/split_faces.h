#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Splits each triangle in four. The new vertex of an edge, shared by its triangles, is `middle(low, high)`
/// of the edge's vertices, that of lower index first. `Vertex` is a position, or any other type that `middle`
/// takes.
template <class Vertex, class Middle>
void splitFaces(std::vector<Vertex>& vertices, std::vector<Face>& faces, Middle middle) {
  std::unordered_map<std::uint64_t, int> made;
  const auto between = [&](int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const std::uint64_t edge = (static_cast<std::uint64_t>(low) << 32) |
                               static_cast<std::uint64_t>(static_cast<std::uint32_t>(high));
    const auto [found, is_new] = made.try_emplace(edge, static_cast<int>(vertices.size()));
    if (is_new) vertices.push_back(middle(vertices[low], vertices[high]));
    return found->second;
  };
  std::vector<Face> finer;
  finer.reserve(4 * faces.size());
  for (const auto& [a, b, c] : faces) {
    const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  faces = std::move(finer);
}

}  // namespace fissure
