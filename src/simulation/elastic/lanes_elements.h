#pragma once

// Present and rest shapes of as many elements as a vector register has doubles. Internal linkage, as in
// lanes.h.

#include "elastic/element_kernels.h"
#include "elastic/lanes_gather.h"
#include "elastic/lanes_law.h"

namespace fissure {
namespace {

/// Pointers to the arrays of `kWidth` elements of a group (see ElementArrays).
struct Elements {
  const int* corners;
  const int* slots;
  const double* inverse_edges;
  const double* metrics;
  Lanes volumes_m3;
};

inline Elements elements(const ElementArrays& arrays, int group, int lane) {
  return {arrays.corners + 4L * kLanes * group + lane, arrays.slots + 4L * kLanes * group + lane,
          arrays.inverse_edges + 9L * kLanes * group + lane, arrays.metrics + 7L * kLanes * group + lane,
          load<Lanes>(arrays.volumes_m3 + 1L * kLanes * group + lane)};
}

/// Values at the first three corners minus that at the fourth: for positions the edges D.
struct Edges {
  Vectors at[3];
};

inline Edges edges(const Elements& elements, const double* values) {
  const Vectors fourth = gather(values, elements.corners + 3 * kLanes);
  return {{gather(values, elements.corners) - fourth, gather(values, elements.corners + kLanes) - fourth,
           gather(values, elements.corners + 2 * kLanes) - fourth}};
}

/// The cofactors of the matrix of edges: twice the area vectors of the faces opposite to the first three
/// corners.
inline Edges areas(const Edges& d) {
  return {{cross(d.at[1], d.at[2]), cross(d.at[2], d.at[0]), cross(d.at[0], d.at[1])}};
}

/// The inverse of the matrix of rest edges, B.
struct InverseEdges {
  Lanes at[3][3];
};

inline InverseEdges inverseEdges(const Elements& elements) {
  InverseEdges b;
  for (int k = 0; k < 9; ++k) b.at[k / 3][k % 3] = load<Lanes>(elements.inverse_edges + kLanes * k);
  return b;
}

/// D G: the edges times the rest metric G = B B^T.
inline Edges timesMetric(const Elements& elements, const Edges& d) {
  Lanes g[6];
  for (int k = 0; k < 6; ++k) g[k] = load<Lanes>(elements.metrics + kLanes * k);
  return {{g[0] * d.at[0] + g[1] * d.at[1] + g[2] * d.at[2], g[1] * d.at[0] + g[3] * d.at[1] + g[4] * d.at[2],
           g[2] * d.at[0] + g[4] * d.at[1] + g[5] * d.at[2]}};
}

/// The gradient, with respect to the rest position, of the field with these edges: for positions the
/// deformation gradient F = D B.
inline Matrices gradient(const InverseEdges& b, const Edges& d) {
  Matrices f;
  for (int j = 0; j < 3; ++j) {
    const Vectors column = b.at[0][j] * d.at[0] + b.at[1][j] * d.at[1] + b.at[2][j] * d.at[2];
    f.at[0][j] = column.x;
    f.at[1][j] = column.y;
    f.at[2][j] = column.z;
  }
  return f;
}

inline Matrices gradient(const Elements& elements, const double* values) {
  return gradient(inverseEdges(elements), edges(elements, values));
}

/// Writes forces on the first three corners, and on the fourth the force that balances them.
inline void scatterForces(const Elements& elements, const Edges& forces, double* to) {
  for (int c = 0; c < 3; ++c) scatter(forces.at[c], elements.slots + kLanes * c, to);
  scatter(Vectors{} - forces.at[0] - forces.at[1] - forces.at[2], elements.slots + 3 * kLanes, to);
}

}  // namespace
}  // namespace fissure
