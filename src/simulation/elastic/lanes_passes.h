#pragma once

// Forces and volume strains of all elements for one instruction set. Internal linkage, as lanes.h.

#include "elastic/lanes_gather.h"
#include "elastic/lanes_law.h"

namespace fissure {
namespace {

/// `kWidth` elements of a group.
struct Elements {
  const int* corners;
  const int* slots;
  const double* inverse_edges;
  Lanes volumes_m3;
};

inline Elements elements(const ElementArrays& arrays, int group, int lane) {
  return {arrays.corners + 4L * kLanes * group + lane, arrays.slots + 4L * kLanes * group + lane,
          arrays.inverse_edges + 9L * kLanes * group + lane,
          load<Lanes>(arrays.volumes_m3 + 1L * kLanes * group + lane)};
}

inline void inverseEdges(const Elements& elements, Lanes (&b)[3][3]) {
  for (int k = 0; k < 9; ++k) b[k / 3][k % 3] = load<Lanes>(elements.inverse_edges + kLanes * k);
}

/// The gradient by the rest position of what is given at the vertices.
inline Matrices gradient(const Elements& elements, const Lanes (&b)[3][3], const double* values) {
  const Vectors fourth = gather(values, elements.corners + 3 * kLanes);
  Vectors edges[3];
  for (int c = 0; c < 3; ++c) edges[c] = gather(values, elements.corners + kLanes * c) - fourth;
  Matrices f;
  for (int j = 0; j < 3; ++j) {
    f.at[0][j] = edges[0].x * b[0][j] + edges[1].x * b[1][j] + edges[2].x * b[2][j];
    f.at[1][j] = edges[0].y * b[0][j] + edges[1].y * b[1][j] + edges[2].y * b[2][j];
    f.at[2][j] = edges[0].z * b[0][j] + edges[1].z * b[1][j] + edges[2].z * b[2][j];
  }
  return f;
}

/// Writes the forces of a stress on the corners.
inline void scatterForces(const Elements& elements, const Lanes (&b)[3][3], const Matrices& stress,
                          double* to) {
  Lanes sums[3] = {};
  for (int c = 0; c < 3; ++c) {
    Lanes force[3];
    for (int i = 0; i < 3; ++i) {
      const Lanes flux = stress.at[i][0] * b[c][0] + stress.at[i][1] * b[c][1] + stress.at[i][2] * b[c][2];
      force[i] = -elements.volumes_m3 * flux;
      sums[i] += force[i];
    }
    scatter({force[0], force[1], force[2]}, elements.slots + kLanes * c, to);
  }
  scatter({-sums[0], -sums[1], -sums[2]}, elements.slots + 3 * kLanes, to);
}

template <ElementModel model, bool viscous, bool averaged>
void forcesOf(const ElementArrays& arrays, const ElementLaw& law, const ForcePass& pass) {
  for (int group = 0; group < arrays.groups; ++group)
    for (int lane = 0; lane < kLanes; lane += kWidth) {
      const Elements some = elements(arrays, group, lane);
      Lanes b[3][3];
      inverseEdges(some, b);
      const Matrices f = gradient(some, b, pass.positions_m);
      Lanes pressure = {};
      if constexpr (averaged) {
        for (int c = 0; c < 4; ++c) pressure += gatherNumbers(pass.pressures_Pa, some.corners + kLanes * c);
        pressure *= 0.25;
      }
      scatterForces(some, b, stress<model>(f, law, pressure), pass.forces_N);
      if constexpr (viscous)
        scatterForces(some, b, viscousStress(f, gradient(some, b, pass.velocities_m_s), law.viscosity_Pa_s),
                      pass.viscous_forces_N);
    }
}

template <ElementModel model>
void forcesOf(const ElementArrays& arrays, const ElementLaw& law, const ForcePass& pass) {
  if (pass.velocities_m_s != nullptr)
    (pass.pressures_Pa != nullptr ? forcesOf<model, true, true> : forcesOf<model, true, false>)(arrays, law,
                                                                                                pass);
  else
    (pass.pressures_Pa != nullptr ? forcesOf<model, false, true> : forcesOf<model, false, false>)(arrays, law,
                                                                                                  pass);
}

void elementForces(const ElementArrays& arrays, const ElementLaw& law, const ForcePass& pass) {
  switch (law.model) {
    case ElementModel::neo_hookean:
      return forcesOf<ElementModel::neo_hookean>(arrays, law, pass);
    case ElementModel::linear_corotated:
      return forcesOf<ElementModel::linear_corotated>(arrays, law, pass);
    case ElementModel::small_strain:
      return forcesOf<ElementModel::small_strain>(arrays, law, pass);
  }
}

void elementVolumeStrains(const ElementArrays& arrays, const ElementLaw& law, const double* positions_m,
                          double* slots) {
  for (int group = 0; group < arrays.groups; ++group)
    for (int lane = 0; lane < kLanes; lane += kWidth) {
      const Elements some = elements(arrays, group, lane);
      Lanes b[3][3];
      inverseEdges(some, b);
      const Matrices f = gradient(some, b, positions_m);
      Lanes strain;
      if (law.model == ElementModel::small_strain) {
        strain = f.at[0][0] + f.at[1][1] + f.at[2][2];
      } else {
        const Matrices cofactor = cofactors(f);
        const Lanes j = determinant(f, cofactor);
        strain = law.model == ElementModel::neo_hookean
                     ? j - 1.0
                     : rotationTrace(normSquared(f), normSquared(cofactor), j) - 3.0;
      }
      strain *= some.volumes_m3;
      for (int c = 0; c < 4; ++c) scatterNumbers(strain, some.slots + kLanes * c, slots);
    }
}

}  // namespace
}  // namespace fissure
