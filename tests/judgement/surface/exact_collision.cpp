#include "exact_collision.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numeric>
#include <vector>

namespace fissure::test {

namespace {

using Rational = boost::multiprecision::cpp_rational;

template <class Integer>
using Exact = std::array<Integer, 3>;

template <class Integer>
struct Moving {
  Exact<Integer> start, end;
};

/// A polynomial on a part of the step by its Bernstein coefficients, times a positive factor.
template <class Integer>
using Polynomial = std::vector<Integer>;

/// The product of two in Bernstein form: binomial weights, so that all stay integral (times a factor).
long long binomial(int n, int k) {
  long long value = 1;
  for (int i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
  return value;
}

/// Weighted coefficients: b_i = binomial(n, i) x Bernstein coefficient. Products are plain convolutions.
template <class Integer>
Polynomial<Integer> product(const Polynomial<Integer>& p, const Polynomial<Integer>& q) {
  Polynomial<Integer> r(p.size() + q.size() - 1, Integer(0));
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) r[i + j] += p[i] * q[j];
  return r;
}

template <class Integer>
Polynomial<Integer> sum(Polynomial<Integer> p, const Polynomial<Integer>& q, int sign = 1) {
  for (std::size_t i = 0; i < p.size(); ++i) p[i] += sign > 0 ? q[i] : Integer(-q[i]);
  return p;
}

/// From weighted to plain Bernstein coefficients, all times the least common multiple of the weights.
template <class Integer>
Polynomial<Integer> plain(Polynomial<Integer> p) {
  const int n = static_cast<int>(p.size()) - 1;
  long long multiple = 1;
  for (int i = 0; i <= n; ++i) multiple = std::lcm(multiple, binomial(n, i));
  for (int i = 0; i <= n; ++i) p[static_cast<std::size_t>(i)] *= multiple / binomial(n, i);
  return p;
}

template <class Integer>
using Vector = std::array<Polynomial<Integer>, 3>;

template <class Integer>
Vector<Integer> path(const Moving<Integer>& from, const Moving<Integer>& to) {
  Vector<Integer> v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = {Integer(to.start[i] - from.start[i]), Integer(to.end[i] - from.end[i])};
  return v;
}

template <class Integer>
Vector<Integer> cross(const Vector<Integer>& a, const Vector<Integer>& b) {
  Vector<Integer> c;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = sum(product(a[j], b[k]), product(a[k], b[j]), -1);
  }
  return c;
}

template <class Integer>
Polynomial<Integer> dot(const Vector<Integer>& a, const Vector<Integer>& b) {
  return sum(sum(product(a[0], b[0]), product(a[1], b[1])), product(a[2], b[2]));
}

/// `volume` is 0 where the primitives' lines or planes meet; there they meet if no bound is negative and
/// `area` is positive.
template <class Integer>
struct Conditions {
  Polynomial<Integer> volume, area;
  std::vector<Polynomial<Integer>> bounds;
};

template <class Integer>
Conditions<Integer> conditionsOf(const std::vector<Moving<Integer>>& one,
                                 const std::vector<Moving<Integer>>& other) {
  Conditions<Integer> all;
  if (one.size() == 1) {
    const Vector<Integer> ab = path(other[0], other[1]), ac = path(other[0], other[2]);
    const Vector<Integer> normal = cross(ab, ac);
    all.volume = plain(dot(normal, path(other[0], one[0])));
    all.area = plain(dot(normal, normal));
    for (std::size_t i = 0; i < 3; ++i)
      all.bounds.push_back(
          plain(dot(normal, cross(path(other[i], other[(i + 1) % 3]), path(other[i], one[0])))));
    return all;
  }
  const Vector<Integer> a = path(one[0], one[1]), b = path(other[0], other[1]);
  const Vector<Integer> between = path(one[0], other[0]);
  const Vector<Integer> normal = cross(a, b);
  all.volume = plain(dot(normal, between));
  const Polynomial<Integer> area = dot(normal, normal);
  all.area = plain(area);
  for (const Vector<Integer>* direction : {&b, &a}) {
    const Polynomial<Integer> share = dot(cross(between, *direction), normal);
    all.bounds.push_back(plain(share));
    all.bounds.push_back(plain(sum(area, share, -1)));
  }
  return all;
}

template <class Integer>
bool allOfSign(const Polynomial<Integer>& p, int sign) {
  return std::all_of(p.begin(), p.end(), [&](const Integer& c) { return sign > 0 ? c > 0 : c < 0; });
}

/// Both halves, times 2^degree: no division.
template <class Integer>
void halve(const Polynomial<Integer>& p, Polynomial<Integer>& left, Polynomial<Integer>& right) {
  const std::size_t n = p.size() - 1;
  Polynomial<Integer> row = p;
  left.assign(p.size(), Integer(0));
  right.assign(p.size(), Integer(0));
  for (std::size_t level = 0; level <= n; ++level) {
    const Integer factor = Integer(1) << static_cast<unsigned>(n - level);
    left[level] = row[0] * factor;
    right[n - level] = row[n - level] * factor;
    for (std::size_t i = 0; i + level < n; ++i) row[i] += row[i + 1];
  }
}

template <class Integer>
Meeting decide(const Conditions<Integer>& all, int depth) {
  if (allOfSign(all.volume, 1) || allOfSign(all.volume, -1)) return Meeting::never;
  for (const auto& bound : all.bounds)
    if (allOfSign(bound, -1)) return Meeting::never;
  for (const bool first : {true, false}) {
    const auto endOf = [&](const Polynomial<Integer>& p) { return first ? p.front() : p.back(); };
    if (endOf(all.volume) == 0 && endOf(all.area) > 0 &&
        std::all_of(all.bounds.begin(), all.bounds.end(), [&](const auto& b) { return endOf(b) >= 0; }))
      return Meeting::certain;
  }
  if (((all.volume.front() < 0 && all.volume.back() > 0) ||
       (all.volume.front() > 0 && all.volume.back() < 0)) &&
      allOfSign(all.area, 1) &&
      std::all_of(all.bounds.begin(), all.bounds.end(), [](const auto& b) { return allOfSign(b, 1); }))
    return Meeting::certain;
  // In one plane all the time: halving shows no more.
  if (depth == 0 ||
      std::all_of(all.volume.begin(), all.volume.end(), [](const Integer& c) { return c == 0; }))
    return Meeting::undecided;
  Conditions<Integer> left, right;
  halve(all.volume, left.volume, right.volume);
  halve(all.area, left.area, right.area);
  for (const auto& bound : all.bounds) halve(bound, left.bounds.emplace_back(), right.bounds.emplace_back());
  const Meeting early = decide(left, depth - 1);
  if (early == Meeting::certain) return early;
  const Meeting late = decide(right, depth - 1);
  if (late == Meeting::certain) return late;
  return early == Meeting::never ? late : early;
}

BigInteger scaled(double value, int exponent) {  // value x 2^exponent, integral
  int own = 0;
  const double mantissa = std::frexp(value, &own);
  const auto digits = static_cast<long long>(std::ldexp(mantissa, 53));
  BigInteger integer = digits;
  const int shift = own - 53 + exponent;
  return shift >= 0 ? BigInteger(integer << static_cast<unsigned>(shift))
                    : BigInteger(integer / (BigInteger(1) << static_cast<unsigned>(-shift)));
}

template <class Integer, class Convert>
std::vector<Moving<Integer>> converted(std::span<const MovingPoint> points, const Convert& convert) {
  std::vector<Moving<Integer>> exact(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t i = 0; i < 3; ++i) {
      exact[p].start[i] = convert(points[p].start[static_cast<Eigen::Index>(i)]);
      exact[p].end[i] = convert(points[p].end[static_cast<Eigen::Index>(i)]);
    }
  return exact;
}

/// How often the step is halved; with coordinates below 2^9 all fits into 128 bits at this depth.
constexpr int kHalvingsOfSmall = 12;
constexpr int kHalvings = 24;

}  // namespace

Meeting exactMeeting(std::span<const MovingPoint> one, std::span<const MovingPoint> other) {
  const auto small = [](double value) { return static_cast<SmallInteger>(value); };
  const Meeting meeting =
      decide(conditionsOf(converted<SmallInteger>(one, small), converted<SmallInteger>(other, small)),
             kHalvingsOfSmall);
  return meeting == Meeting::undecided ? exactMeetingOfDoubles(one, other) : meeting;
}

Meeting exactMeetingOfDoubles(std::span<const MovingPoint> one, std::span<const MovingPoint> other) {
  int exponent = 0;  // under which all coordinates are integral
  for (const auto& points : {one, other})
    for (const MovingPoint& point : points)
      for (const Vec3* end : {&point.start, &point.end})
        for (const double coordinate : *end) {
          if (coordinate == 0) continue;
          int own = 0;
          std::frexp(coordinate, &own);
          exponent = std::max(exponent, 53 - own);
        }
  const auto big = [&](double value) { return scaled(value, exponent); };
  return decide(conditionsOf(converted<BigInteger>(one, big), converted<BigInteger>(other, big)), kHalvings);
}

bool isWitness(std::span<const MovingPoint> one, std::span<const MovingPoint> other, double time,
               std::span<const double> shares_of_one, std::span<const double> shares_of_other) {
  const auto pointOf = [&](std::span<const MovingPoint> piece, std::span<const double> shares) {
    std::array<Rational, 3> point;
    for (std::size_t p = 0; p < piece.size(); ++p)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        const Rational start(piece[p].start[axis]), end(piece[p].end[axis]);
        point[i] += Rational(shares[p]) * (start + Rational(time) * (end - start));
      }
    return point;
  };
  return pointOf(one, shares_of_one) == pointOf(other, shares_of_other);
}

}  // namespace fissure::test
