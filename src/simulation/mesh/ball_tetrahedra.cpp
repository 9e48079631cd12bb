#include "mesh/ball_tetrahedra.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "mesh/primitives.h"
#include "mesh/split_faces.h"
#include "mesh/tetrahedron.h"

namespace fissure {
namespace {

using Point = OctahedronPoint;

Point plus(const Point& a, const Point& b, int times = 1) {
  return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}

int layerOf(const Point& p) {
  return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
}

std::size_t placeIn(int layers, const Point& p) {
  const std::size_t side = 2 * static_cast<std::size_t>(layers) + 1;
  const auto at = [&](std::size_t axis) {
    const int from_end = p[axis] + layers;
    return static_cast<std::size_t>(from_end);
  };
  return at(0) + side * (at(1) + side * at(2));
}

/// The points of the surface in the order of makeSphere's vertices.
std::vector<Point> surfacePoints(int layers, int subdivisions) {
  const int n = layers;
  std::vector<Point> points = {{n, 0, 0}, {-n, 0, 0}, {0, n, 0}, {0, -n, 0}, {0, 0, n}, {0, 0, -n}};
  std::vector<Face> faces = makeSphere(1, 0).faces;
  const auto middle = [](const Point& a, const Point& b) {
    return Point{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  };
  for (int level = 0; level < subdivisions; ++level) splitFaces(points, faces, middle);
  return points;
}

/// Directions from a new point of the lattice to those of twice the spacing whose middle it is, and the
/// opposite ones, by which of its coordinates are odd: the ends of an edge, or the six corners of an
/// octahedron.
std::vector<Point> towardsParents(const Point& odd) {
  const int count = odd[0] + odd[1] + odd[2];
  if (count == 1) return {odd};
  if (count == 3) return {{1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  Point way = odd;
  way[odd[0] == 1 ? 0 : 1] = -1;
  return {way};
}

/// What lies in x, y, z >= 0; the other octants are its mirror images.
class Octant {
 public:
  explicit Octant(int layers)
      : layers_(layers),
        side_(static_cast<std::size_t>(layers) + 1),
        positions_(side_ * side_ * side_, Vec3::Zero()) {
    at({layers, 0, 0}) = Vec3::UnitX();
    at({0, layers, 0}) = Vec3::UnitY();
    at({0, 0, layers}) = Vec3::UnitZ();
    for (int spacing = layers / 2; spacing > 0; spacing /= 2) placeBetween(spacing);
  }

  /// In a ball of radius 1.
  const Vec3& position(const Point& p) const { return positions_[place(p)]; }

  /// By their corners.
  std::vector<std::array<Point, 4>> tetrahedra() const {
    std::vector<std::array<Point, 4>> made;
    forEach(1, [&](const Point& p) {
      const int left = layers_ - layerOf(p);
      if (left < 1) return;
      const Point x = plus(p, {1, 0, 0}), y = plus(p, {0, 1, 0}), z = plus(p, {0, 0, 1});
      made.push_back({p, x, y, z});
      if (left >= 2) addOctahedron(p, made);
      if (left >= 3)
        made.push_back({plus(p, {1, 1, 1}), plus(p, {1, 0, 1}), plus(p, {0, 1, 1}), plus(p, {1, 1, 0})});
    });
    return made;
  }

 private:
  std::size_t place(const Point& p) const {
    const auto [i, j, k] = p;
    return static_cast<std::size_t>(i) +
           side_ * (static_cast<std::size_t>(j) + side_ * static_cast<std::size_t>(k));
  }
  Vec3& at(const Point& p) { return positions_[place(p)]; }

  template <class Visit>
  void forEach(int spacing, Visit visit) const {
    for (int k = 0; k <= layers_; k += spacing)
      for (int j = 0; j + k <= layers_; j += spacing)
        for (int i = 0; i + j + k <= layers_; i += spacing) visit(Point{i, j, k});
  }

  void placeBetween(int spacing) {
    forEach(spacing, [&](const Point& p) {
      const Point odd = {p[0] / spacing % 2, p[1] / spacing % 2, p[2] / spacing % 2};
      if (odd == Point{}) return;
      Vec3 middle = Vec3::Zero();
      for (const Point& way : towardsParents(odd))
        middle += position(plus(p, way, spacing)) + position(plus(p, way, -spacing));
      at(p) = static_cast<double>(layerOf(p)) / layers_ * middle.normalized();
    });
  }

  /// That of the corners p + x, y, z, y + z, z + x, x + y, around the best of its diagonals.
  void addOctahedron(const Point& p, std::vector<std::array<Point, 4>>& made) const {
    constexpr double tie = 1e-9;  // the first of diagonals as good as each other, whatever their rounding
    double best = 0;
    std::array<std::array<Point, 4>, 4> chosen{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Point a{}, b{}, c{};
      a[axis] = b[(axis + 1) % 3] = c[(axis + 2) % 3] = 1;
      const Point from = plus(p, a), to = plus(plus(p, b), c);
      const std::array<Point, 4> ring = {plus(p, b), plus(p, c), plus(plus(p, c), a), plus(plus(p, a), b)};
      std::array<std::array<Point, 4>, 4> around{};
      double worst = 1;
      for (std::size_t k = 0; k < 4; ++k) {
        around[k] = {from, to, ring[k], ring[(k + 1) % 4]};
        worst = std::min(worst, radiusRatio({position(around[k][0]), position(around[k][1]),
                                             position(around[k][2]), position(around[k][3])}));
      }
      if (axis > 0 && worst <= best + tie) continue;
      best = worst;
      chosen = around;
    }
    made.insert(made.end(), chosen.begin(), chosen.end());
  }

  int layers_;
  std::size_t side_;
  std::vector<Vec3> positions_;
};

void addInside(const Octant& octant, double radius_m, BallTetrahedra& ball) {
  const int inner = ball.layers - 1;
  for (int k = -inner; k <= inner; ++k) {
    for (int j = -inner; j <= inner; ++j) {
      for (int i = -inner; i <= inner; ++i) {
        const Point p = {i, j, k};
        if (layerOf(p) > inner) continue;
        const Vec3& position = octant.position({std::abs(i), std::abs(j), std::abs(k)});
        const Vec3 sign(i < 0 ? -1 : 1, j < 0 ? -1 : 1, k < 0 ? -1 : 1);
        ball.vertices[placeIn(ball.layers, p)] = static_cast<int>(ball.points.size());
        ball.points.push_back(p);
        ball.mesh.vertices_m.push_back(radius_m * position.cwiseProduct(sign));
      }
    }
  }
}

}  // namespace

int BallTetrahedra::vertex(const OctahedronPoint& point) const {
  return vertices[placeIn(layers, point)];
}

BallTetrahedra makeBallTetrahedra(double radius_m, int subdivisions) {
  assert(radius_m > 0 && subdivisions >= 0);
  BallTetrahedra ball;
  ball.layers = 1 << subdivisions;
  ball.mesh.vertices_m = makeSphere(radius_m, subdivisions).vertices_m;
  ball.points = surfacePoints(ball.layers, subdivisions);
  ball.on_surface = ball.points.size();
  ball.vertices.assign(placeIn(ball.layers, {ball.layers, ball.layers, ball.layers}) + 1, -1);
  for (std::size_t v = 0; v < ball.on_surface; ++v)
    ball.vertices[placeIn(ball.layers, ball.points[v])] = static_cast<int>(v);
  const Octant octant(ball.layers);
  addInside(octant, radius_m, ball);
  const std::vector<std::array<Point, 4>> own = octant.tetrahedra();
  ball.mesh.tetrahedra.reserve(8 * own.size());
  for (int signs = 0; signs < 8; ++signs) {
    const int x = (signs & 1) ? -1 : 1, y = (signs & 2) ? -1 : 1, z = (signs & 4) ? -1 : 1;
    for (const std::array<Point, 4>& corners : own) {
      Tetrahedron made{};
      for (std::size_t k = 0; k < 4; ++k)
        made[k] = ball.vertex({x * corners[k][0], y * corners[k][1], z * corners[k][2]});
      if (x * y * z < 0) std::swap(made[2], made[3]);
      ball.mesh.tetrahedra.push_back(made);
    }
  }
  return ball;
}

}  // namespace fissure
