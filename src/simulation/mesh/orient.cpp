#include "mesh/orient.h"

#include <algorithm>
#include <vector>

#include "mesh/edges.h"
#include "mesh/shells.h"

namespace fissure {
namespace {

struct Neighbour {
  int face = 0;
  bool agrees = false;
};

/// Triangles that hang together by edges of exactly two.
struct Piece {
  std::vector<int> faces;
  std::vector<char> turned;  ///< against the first, to agree with it; one per face
  bool closed = true;        ///< and consistent as it is
};

std::vector<Piece> piecesOf(const TriangleMesh& mesh) {
  std::vector<std::vector<Neighbour>> neighbours(mesh.faces.size());
  std::vector<char> closed(mesh.faces.size(), 1);
  forEachEdge(edgeUses(mesh.faces), [&](auto first, auto last) {
    const bool agree = last - first == 2 && first->forward != (first + 1)->forward;
    if (last - first == 2) {
      neighbours[first->face].push_back({(first + 1)->face, agree});
      neighbours[(first + 1)->face].push_back({first->face, agree});
    }
    if (!agree)
      for (auto use = first; use != last; ++use) closed[use->face] = 0;
  });
  std::vector<Piece> pieces;
  std::vector<int> turned(mesh.faces.size(), -1);  // -1: not seen
  for (std::size_t start = 0; start < mesh.faces.size(); ++start) {
    if (turned[start] >= 0) continue;
    Piece piece{{static_cast<int>(start)}, {}, true};
    turned[start] = 0;
    for (std::size_t i = 0; i < piece.faces.size(); ++i) {
      const int face = piece.faces[i];
      piece.turned.push_back(static_cast<char>(turned[face]));
      piece.closed = piece.closed && closed[face] && !repeatsCorner(mesh.faces[face]);
      for (const auto& [other, agrees] : neighbours[face]) {
        if (turned[other] >= 0) continue;
        turned[other] = agrees ? turned[face] : 1 - turned[face];
        piece.faces.push_back(other);
      }
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void turn(Face& face) {
  std::swap(face[1], face[2]);
}

/// Can the piece be made consistent, or does it have one side only?
bool isOrientable(const TriangleMesh& mesh, const Piece& piece) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < piece.faces.size(); ++i) {
    faces.push_back(mesh.faces[piece.faces[i]]);
    if (piece.turned[i]) turn(faces.back());
  }
  bool good = true;
  forEachEdge(edgeUses(faces), [&](auto first, auto last) {
    good = good && !(last - first == 2 && first->forward == (first + 1)->forward);
  });
  return good;
}

}  // namespace

std::size_t orientConsistently(TriangleMesh& mesh) {
  std::size_t count = 0;
  for (const Piece& piece : piecesOf(mesh)) {
    if (!isOrientable(mesh, piece)) continue;
    const auto against = static_cast<std::size_t>(std::count(piece.turned.begin(), piece.turned.end(), 1));
    const bool first_stays = 2 * against <= piece.faces.size();
    for (std::size_t i = 0; i < piece.faces.size(); ++i) {
      if ((piece.turned[i] != 0) != first_stays) continue;
      turn(mesh.faces[piece.faces[i]]);
      ++count;
    }
  }
  return count;
}

std::size_t turnOutward(TriangleMesh& mesh) {
  std::vector<Piece> closed;
  std::vector<std::vector<Face>> surfaces;
  for (Piece& piece : piecesOf(mesh)) {
    if (!piece.closed) continue;
    surfaces.emplace_back();
    for (const int face : piece.faces) surfaces.back().push_back(mesh.faces[face]);
    closed.push_back(std::move(piece));
  }
  const Nesting nesting(mesh, surfaces);
  std::size_t count = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const bool outward = signedVolume(mesh, surfaces[i]) >= 0;
    if (outward == (nesting.depth(i) % 2 == 0)) continue;
    for (const int face : closed[i].faces) turn(mesh.faces[face]);
    ++count;
  }
  return count;
}

void mirror(TriangleMesh& mesh) {
  for (Vec3& vertex : mesh.vertices_m) vertex.x() = -vertex.x();
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
}

}  // namespace fissure
