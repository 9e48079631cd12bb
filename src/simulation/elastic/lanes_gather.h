#pragma once

// Loads numbers and vectors of vertices into lanes, and stores lanes into slots. Internal linkage, as in
// lanes.h.

#include "elastic/lanes.h"

namespace fissure {
namespace {

struct Vectors {
  Lanes x, y, z;
};

inline Vectors operator-(const Vectors& a, const Vectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vectors operator+(const Vectors& a, const Vectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vectors operator*(const Lanes& factor, const Vectors& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
inline Lanes dot(const Vectors& a, const Vectors& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vectors cross(const Vectors& a, const Vectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

#if FISSURE_LANE_WIDTH > 2
/// Transposes four rows of three numbers into columns; the number behind each row is read but not used.
inline void columns(const double* values, const int* rows, Four& x, Four& y, Four& z) {
  const Four a = load<Four>(values + 3L * rows[0]), b = load<Four>(values + 3L * rows[1]),
             c = load<Four>(values + 3L * rows[2]), d = load<Four>(values + 3L * rows[3]);
  const Four ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             ab_y = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             cd_y = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  x = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5);
  y = __builtin_shufflevector(ab_y, cd_y, 0, 1, 4, 5);
  z = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7);
}

inline void scatterFour(const Four& x, const Four& y, const Four& z, const int* slots, double* to) {
  const Four xy_02 = __builtin_shufflevector(x, y, 0, 4, 2, 6),
             xy_13 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const Four z_02 = __builtin_shufflevector(z, z, 0, 4, 2, 6),
             z_13 = __builtin_shufflevector(z, z, 1, 5, 3, 7);
  store(__builtin_shufflevector(xy_02, z_02, 0, 1, 4, 5), to + 4L * slots[0]);
  store(__builtin_shufflevector(xy_13, z_13, 0, 1, 4, 5), to + 4L * slots[1]);
  store(__builtin_shufflevector(xy_02, z_02, 2, 3, 6, 7), to + 4L * slots[2]);
  store(__builtin_shufflevector(xy_13, z_13, 2, 3, 6, 7), to + 4L * slots[3]);
}
#endif

/// Loads the vectors of `kWidth` vertices.
inline Vectors gather(const double* values, const int* vertices) {
  Vectors found;
#if FISSURE_LANE_WIDTH == 8
  Four x[2], y[2], z[2];
  columns(values, vertices, x[0], y[0], z[0]);
  columns(values, vertices + 4, x[1], y[1], z[1]);
  found.x = __builtin_shufflevector(x[0], x[1], 0, 1, 2, 3, 4, 5, 6, 7);
  found.y = __builtin_shufflevector(y[0], y[1], 0, 1, 2, 3, 4, 5, 6, 7);
  found.z = __builtin_shufflevector(z[0], z[1], 0, 1, 2, 3, 4, 5, 6, 7);
#elif FISSURE_LANE_WIDTH == 4
  columns(values, vertices, found.x, found.y, found.z);
#else
  const double *a = values + 3L * vertices[0], *b = values + 3L * vertices[1];
  found = {Lanes{a[0], b[0]}, Lanes{a[1], b[1]}, Lanes{a[2], b[2]}};
#endif
  return found;
}

/// Stores vectors into the slots of `kWidth` corners.
inline void scatter(const Vectors& values, const int* slots, double* to) {
#if FISSURE_LANE_WIDTH == 8
  const auto low = [](const Lanes& v) { return __builtin_shufflevector(v, v, 0, 1, 2, 3); };
  const auto high = [](const Lanes& v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7); };
  scatterFour(low(values.x), low(values.y), low(values.z), slots, to);
  scatterFour(high(values.x), high(values.y), high(values.z), slots + 4, to);
#elif FISSURE_LANE_WIDTH == 4
  scatterFour(values.x, values.y, values.z, slots, to);
#else
  for (int lane = 0; lane < kWidth; ++lane) {
    double* slot = to + 4L * slots[lane];
    slot[0] = values.x[lane];
    slot[1] = values.y[lane];
    slot[2] = values.z[lane];
  }
#endif
}

/// Loads the numbers of `kWidth` vertices.
inline Lanes gatherNumbers(const double* values, const int* vertices) {
  Lanes found;
  for (int lane = 0; lane < kWidth; ++lane) found[lane] = values[vertices[lane]];
  return found;
}

inline void scatterNumbers(const Lanes& values, const int* slots, double* to) {
  for (int lane = 0; lane < kWidth; ++lane) to[slots[lane]] = values[lane];
}

}  // namespace
}  // namespace fissure
