#include "mesh/capsule_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/ball_tetrahedra.h"
#include "mesh/primitives.h"

namespace fissure {
namespace {

/// The ball's section x = 0.
struct Section {
  std::vector<int> vertices;  ///< of the ball; the faces and what else is said of the section count in these
  std::vector<int> numbers;   ///< of the ball's vertices among these, -1 of others
  std::vector<Face> faces;    ///< counter-clockwise about x
};

Section sectionOf(const BallTetrahedra& ball) {
  Section section;
  section.numbers.assign(ball.points.size(), -1);
  for (std::size_t v = 0; v < ball.points.size(); ++v) {
    if (ball.points[v][0] != 0) continue;
    section.numbers[v] = static_cast<int>(section.vertices.size());
    section.vertices.push_back(static_cast<int>(v));
  }
  for (const auto& [y_sign, z_sign] : {std::array{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}) {
    const auto at = [&, y_to = y_sign, z_to = z_sign](int y, int z) {
      return section.numbers[static_cast<std::size_t>(ball.vertex({0, y_to * y, z_to * z}))];
    };
    const auto add = [&, turned = y_sign * z_sign < 0](Face face) {
      if (turned) std::swap(face[1], face[2]);
      section.faces.push_back(face);
    };
    for (int z = 0; z < ball.layers; ++z) {
      for (int y = 0; y + z < ball.layers; ++y) {
        add({at(y, z), at(y + 1, z), at(y, z + 1)});
        if (y + z + 2 <= ball.layers) add({at(y + 1, z), at(y + 1, z + 1), at(y, z + 1)});
      }
    }
  }
  return section;
}

/// Where each vertex of the section stands in the order that cuts the prisms: in every other row the diagonal
/// of the quad between two of them runs from the one before to the one after, in those between the other way.
/// The ring alternates between first and last, as the diagonals of the surface do; the inside, a lattice of
/// triangles each of which has all three remainders, comes between. Since this is an order, each prism can be
/// cut along its three diagonals.
std::vector<int> orderIn(const Section& section, const BallTetrahedra& ball, const std::vector<int>& ring) {
  std::vector<int> order;
  for (const int v : section.vertices) {
    const auto [x, y, z] = ball.points[static_cast<std::size_t>(v)];
    order.push_back(1 + (ball.layers + std::abs(y) - std::abs(z)) % 3);
  }
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const int number = section.numbers[static_cast<std::size_t>(ring[j])];
    order[static_cast<std::size_t>(number)] = j % 2 == 0 ? 4 : 0;
  }
  return order;
}

struct PrismOrder {
  const std::vector<int>& of_vertices;
  bool forward;  ///< or from last to first
};

/// The three tetrahedra of the prism between a triangle in one row, counter-clockwise seen from the next, and
/// its place in the next.
void addPrism(const Face& corners, const PrismOrder& order, const std::vector<int>& row,
              const std::vector<int>& next, std::vector<Tetrahedron>& made) {
  std::array<std::size_t, 3> by_order = {0, 1, 2};
  std::sort(by_order.begin(), by_order.end(), [&](std::size_t a, std::size_t b) {
    const int of_a = order.of_vertices[static_cast<std::size_t>(corners[a])];
    const int of_b = order.of_vertices[static_cast<std::size_t>(corners[b])];
    return order.forward ? of_a < of_b : of_a > of_b;
  });
  const auto [p, q, r] = by_order;
  const auto in = [&](const std::vector<int>& vertices, std::size_t k) {
    return vertices[static_cast<std::size_t>(corners[k])];
  };
  const bool even = (p + 1) % 3 == q;
  for (Tetrahedron one : {Tetrahedron{in(row, p), in(row, q), in(row, r), in(next, r)},
                          Tetrahedron{in(row, p), in(next, q), in(row, q), in(next, r)},
                          Tetrahedron{in(row, p), in(next, p), in(next, q), in(next, r)}}) {
    if (!even) std::swap(one[1], one[2]);
    made.push_back(one);
  }
}

/// Appends the vertices inside both half balls. The capsule's for each of the ball's, on whose section they
/// are those of the left half.
std::vector<int> addHalves(const BallTetrahedra& ball, double length_m, std::vector<Vec3>& vertices_m) {
  std::vector<int> halves(ball.points.size());
  std::iota(halves.begin(), halves.begin() + static_cast<std::ptrdiff_t>(ball.on_surface), 0);
  for (std::size_t v = ball.on_surface; v < halves.size(); ++v) {
    halves[v] = static_cast<int>(vertices_m.size());
    vertices_m.push_back(ball.mesh.vertices_m[v]);
    vertices_m.back().x() += ball.points[v][0] > 0 ? length_m / 2 : -length_m / 2;
  }
  return halves;
}

/// Appends the section's inner vertices at x_m. The capsule's for each of the section's, -1 on its ring.
std::vector<int> addRow(const Section& section, const BallTetrahedra& ball, double x_m,
                        std::vector<Vec3>& vertices_m) {
  std::vector<int> row(section.vertices.size(), -1);
  for (std::size_t s = 0; s < row.size(); ++s) {
    const auto v = static_cast<std::size_t>(section.vertices[s]);
    if (v < ball.on_surface) continue;
    const Vec3& in_ball_m = ball.mesh.vertices_m[v];
    row[s] = static_cast<int>(vertices_m.size());
    vertices_m.emplace_back(x_m, in_ball_m.y(), in_ball_m.z());
  }
  return row;
}

}  // namespace

TetrahedralMesh makeCapsuleTetrahedra(double radius_m, double length_m, int subdivisions, int rows) {
  CapsuleSurface surface = makeCapsuleSurface(radius_m, length_m, subdivisions, rows);
  const BallTetrahedra ball = makeBallTetrahedra(radius_m, subdivisions);
  const Section section = sectionOf(ball);
  const std::vector<int>& ring = surface.rings.front();
  const std::vector<int> order = orderIn(section, ball, ring);
  TetrahedralMesh capsule{std::move(surface.mesh.vertices_m), {}};
  const std::vector<int> halves = addHalves(ball, length_m, capsule.vertices_m);
  std::vector<int> row;
  for (const int v : section.vertices) row.push_back(halves[static_cast<std::size_t>(v)]);
  for (int r = 0; r < rows; ++r) {
    const double next_m = length_m * (static_cast<double>(r + 1) / rows - 0.5);
    std::vector<int> next = addRow(section, ball, next_m, capsule.vertices_m);
    const std::vector<int>& next_ring = surface.rings[static_cast<std::size_t>(r) + 1];
    for (std::size_t j = 0; j < ring.size(); ++j)
      next[static_cast<std::size_t>(section.numbers[static_cast<std::size_t>(ring[j])])] = next_ring[j];
    for (const Face& corners : section.faces)
      addPrism(corners, {order, r % 2 == 0}, row, next, capsule.tetrahedra);
    row = std::move(next);
  }
  const auto x = [&](int v) { return ball.points[static_cast<std::size_t>(v)][0]; };
  for (const Tetrahedron& of_ball : ball.mesh.tetrahedra) {
    const bool right = std::any_of(of_ball.begin(), of_ball.end(), [&](int v) { return x(v) > 0; });
    Tetrahedron made{};
    std::transform(of_ball.begin(), of_ball.end(), made.begin(), [&](int v) {
      const auto at = static_cast<std::size_t>(v);
      return right && x(v) == 0 ? row[static_cast<std::size_t>(section.numbers[at])] : halves[at];
    });
    capsule.tetrahedra.push_back(made);
  }
  return capsule;
}

}  // namespace fissure
