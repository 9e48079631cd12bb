#include "exact_overlap.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "surface/oracles.h"

namespace fissure::test {

namespace {

using Rational = boost::multiprecision::cpp_rational;

/// Sign of the volume of a tetrahedron; Shewchuk's (1997) bound tells when doubles do not decide it.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double volume = u.dot(v.cross(w));
  const double magnitude = u.cwiseAbs().dot(Vec3(std::abs(v.y() * w.z()) + std::abs(v.z() * w.y()),
                                                 std::abs(v.z() * w.x()) + std::abs(v.x() * w.z()),
                                                 std::abs(v.x() * w.y()) + std::abs(v.y() * w.x())));
  if (std::abs(volume) > 1e-15 * magnitude) return volume > 0 ? 1 : -1;
  using Exact = std::array<Rational, 3>;
  const auto difference = [](const Vec3& p, const Vec3& q) {
    return Exact{Rational(p.x()) - Rational(q.x()), Rational(p.y()) - Rational(q.y()),
                 Rational(p.z()) - Rational(q.z())};
  };
  const Exact x = difference(a, d), y = difference(b, d), z = difference(c, d);
  const Rational exact = x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
                         x[2] * (y[0] * z[1] - y[1] * z[0]);
  return exact.sign();
}

using Triangle = std::array<Vec3, 3>;

/// The same of an area seen along an axis, where all points lie in one plane.
int turn(const Vec3& a, const Vec3& b, const Vec3& c, Eigen::Index axis) {
  const Eigen::Index i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Rational area = (Rational(b[i]) - Rational(a[i])) * (Rational(c[j]) - Rational(a[j])) -
                        (Rational(b[j]) - Rational(a[j])) * (Rational(c[i]) - Rational(a[i]));
  return area.sign();
}

bool isBetween(const Vec3& a, const Vec3& b, const Vec3& c) {  // c on the line through a and b
  return ((c.array() >= a.array().min(b.array())) && (c.array() <= a.array().max(b.array()))).all();
}

bool meetInPlane(const Vec3& p, const Vec3& q, const Triangle& t) {
  Eigen::Index axis = 0;
  while (axis < 3 && turn(t[0], t[1], t[2], axis) == 0) ++axis;
  if (axis == 3) return true;  // a triangle without area: counted as meeting
  const int side = turn(t[0], t[1], t[2], axis);
  for (const Vec3* point : {&p, &q}) {
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i)
      inside = inside && turn(t[i], t[(i + 1) % 3], *point, axis) * side >= 0;
    if (inside) return true;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = t[i], &b = t[(i + 1) % 3];
    const int ap = turn(p, q, a, axis), bp = turn(p, q, b, axis), pa = turn(a, b, p, axis),
              qa = turn(a, b, q, axis);
    if (ap * bp < 0 && pa * qa < 0) return true;
    if ((ap == 0 && isBetween(p, q, a)) || (bp == 0 && isBetween(p, q, b)) ||
        (pa == 0 && isBetween(a, b, p)) || (qa == 0 && isBetween(a, b, q)))
      return true;
  }
  return false;
}

bool meet(const Vec3& p, const Vec3& q, const Triangle& t) {
  const int at_p = orientation(t[0], t[1], t[2], p), at_q = orientation(t[0], t[1], t[2], q);
  if (at_p * at_q > 0) return false;
  if (at_p == 0 && at_q == 0) return meetInPlane(p, q, t);
  int positive = 0, negative = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = orientation(p, q, t[i], t[(i + 1) % 3]);
    positive += side > 0;
    negative += side < 0;
  }
  return positive == 0 || negative == 0;
}

Triangle cornersOf(const TriangleMesh& mesh, const Face& face) {
  Triangle t;
  for (std::size_t i = 0; i < 3; ++i) t[i] = mesh.vertices_m[static_cast<std::size_t>(face[i])];
  return t;
}

bool boxesMeet(const Triangle& s, const Triangle& t) {
  const auto low = [](const Triangle& x) { return x[0].cwiseMin(x[1]).cwiseMin(x[2]).eval(); };
  const auto high = [](const Triangle& x) { return x[0].cwiseMax(x[1]).cwiseMax(x[2]).eval(); };
  return (low(s).array() <= high(t).array()).all() && (low(t).array() <= high(s).array()).all();
}

/// The faces that are connected with the first of `faces`, taken out of them.
TriangleMesh takePart(const TriangleMesh& mesh, std::vector<Face>& faces) {
  TriangleMesh part{mesh.vertices_m, {}};
  std::set<int> reached(faces.front().begin(), faces.front().end());
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = faces.size(); i-- > 0;) {
      const Face face = faces[i];
      if (std::none_of(face.begin(), face.end(), [&](int v) { return reached.contains(v); })) continue;
      reached.insert(face.begin(), face.end());
      part.faces.push_back(face);
      faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(i));
      grows = true;
    }
  }
  return part;
}

bool encloses(const TriangleMesh& mesh, const TriangleMesh& other) {
  for (std::vector<Face> left = mesh.faces; !left.empty();) {
    const TriangleMesh part = takePart(mesh, left);
    for (const Face& face : other.faces)
      if (std::abs(solidAngleWinding(part, other.vertices_m[static_cast<std::size_t>(face[0])])) > 0.5)
        return true;
  }
  return false;
}

}  // namespace

bool exactOverlap(const TriangleMesh& one, const TriangleMesh& other, bool other_closed) {
  for (const Face& f : one.faces)
    for (const Face& g : other.faces) {
      const Triangle s = cornersOf(one, f), t = cornersOf(other, g);
      if (!boxesMeet(s, t)) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (meet(s[i], s[(i + 1) % 3], t) || meet(t[i], t[(i + 1) % 3], s)) return true;
    }
  return encloses(one, other) || (other_closed && encloses(other, one));
}

}  // namespace fissure::test
