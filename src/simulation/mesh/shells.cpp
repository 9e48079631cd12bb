#include "mesh/shells.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "base/reproducible.h"
#include "mesh/triangle.h"

namespace fissure {
namespace {

double windingAt(const TriangleMesh& mesh, const std::vector<Face>& faces, const Vec3& point) {
  double half_angle = 0;
  for (const Face& face : faces) {
    const auto corners = cornersOf(mesh, face);
    const Vec3 a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    half_angle +=
        reproducible::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return half_angle / (2 * std::numbers::pi);
}

}  // namespace

std::vector<int> shellsOf(const TriangleMesh& mesh) {
  std::vector<int> parents(mesh.vertices_m.size());
  std::iota(parents.begin(), parents.end(), 0);
  const auto root = [&](int v) {
    while (parents[v] != v) v = parents[v] = parents[parents[v]];
    return v;
  };
  for (const Face& face : mesh.faces)
    for (const int v : {face[1], face[2]}) parents[root(v)] = root(face[0]);
  std::vector<int> number(mesh.vertices_m.size(), -1), shells;
  shells.reserve(mesh.faces.size());
  int count = 0;
  for (const Face& face : mesh.faces) {
    int& shell = number[root(face[0])];
    if (shell < 0) shell = count++;
    shells.push_back(shell);
  }
  return shells;
}

std::vector<std::vector<Face>> splitShells(const TriangleMesh& mesh) {
  const std::vector<int> numbers = shellsOf(mesh);
  std::vector<std::vector<Face>> shells;
  for (std::size_t f = 0; f < numbers.size(); ++f) {
    const auto number = static_cast<std::size_t>(numbers[f]);
    if (number == shells.size()) shells.emplace_back();
    shells[number].push_back(mesh.faces[f]);
  }
  return shells;
}

Nesting::Nesting(const TriangleMesh& mesh, const std::vector<std::vector<Face>>& surfaces)
    : mesh_(mesh), surfaces_(surfaces) {
  for (const std::vector<Face>& faces : surfaces) {
    bounds_.emplace_back();
    for (const Face& face : faces)
      for (const Vec3& corner : cornersOf(mesh, face)) bounds_.back().extend(corner);
  }
}

int Nesting::depth(std::size_t index) const {
  const Vec3 point = cornersOf(mesh_, surfaces_[index].front())[0];
  int depth = 0;
  for (std::size_t other = 0; other < surfaces_.size(); ++other) {
    if (other == index || !bounds_[other].contains(point)) continue;
    depth += std::abs(windingAt(mesh_, surfaces_[other], point)) > 0.5;
  }
  return depth;
}

double signedVolume(const TriangleMesh& mesh, const std::vector<Face>& faces) {
  if (faces.empty()) return 0;
  // Measured from a vertex, not from the scene's origin: a small body far away would lose its digits.
  const Vec3 from = cornersOf(mesh, faces.front())[0];
  double six_volumes = 0;
  for (const Face& face : faces) {
    const auto [a, b, c] = cornersOf(mesh, face);
    six_volumes += Vec3(a - from).dot(Vec3(b - from).cross(Vec3(c - from)));
  }
  return six_volumes / 6;
}

}  // namespace fissure
