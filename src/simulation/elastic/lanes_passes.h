#pragma once

// Forces and volume strains of all elements for one instruction set. Internal linkage, as in lanes.h.

#include "elastic/lanes_elements.h"

namespace fissure {
namespace {

/// Forces on the first three corners: -V P B^T with the rest volume V, the first Piola-Kirchhoff stress P and
/// the inverse B of the matrix of rest edges.
template <ElementModel model>
inline Edges stressForces(const Elements& some, const ElementLaw& law, const Edges& d,
                          const Lanes& pressure) {
  const InverseEdges b = inverseEdges(some);
  const Matrices p = stress<model>(gradient(b, d), law, pressure);
  const Lanes scale = -some.volumes_m3;
  Edges forces;
  for (int c = 0; c < 3; ++c)
    forces.at[c] = {scale * (p.at[0][0] * b.at[c][0] + p.at[0][1] * b.at[c][1] + p.at[0][2] * b.at[c][2]),
                    scale * (p.at[1][0] * b.at[c][0] + p.at[1][1] * b.at[c][1] + p.at[1][2] * b.at[c][2]),
                    scale * (p.at[2][0] * b.at[c][0] + p.at[2][1] * b.at[c][1] + p.at[2][2] * b.at[c][2])};
  return forces;
}

/// The same for the neo-Hookean law, which needs no F: with the edges D and the rest metric G, I_C = D . D G,
/// and the forces are -V mu' I_C / (I_C + 1) D G + lambda' (J - alpha) cof D / 6. Padding lanes of a group
/// have no volume, and their results are never read.
inline Edges neoHookeanForces(const Elements& some, const ElementLaw& law, const Edges& d,
                              const Edges& d_metric, const Lanes& pressure) {
  const Edges area = areas(d);
  const Lanes j = dot(d.at[0], area.at[0]) * load<Lanes>(some.metrics + 6 * kLanes);
  const Lanes i = dot(d.at[0], d_metric.at[0]) + dot(d.at[1], d_metric.at[1]) + dot(d.at[2], d_metric.at[2]);
  const Lanes of_metric = -law.mu_Pa * some.volumes_m3 * i / (i + 1.0);
  const Lanes of_area = (law.lambda_Pa * (j - law.alpha) + pressure) * (1.0 / 6);
  Edges forces;
  for (int c = 0; c < 3; ++c) forces.at[c] = of_metric * d_metric.at[c] + of_area * area.at[c];
  return forces;
}

/// Forces of the viscous stress F S with S = eta (F^T L + L^T F) and L = dF/dt: -V eta D G M G with M = D^T W
/// + W^T D and the rates W of the edges.
inline Edges viscousForces(const Elements& some, const ElementLaw& law, const Edges& d, const Edges& d_metric,
                           const Edges& rate) {
  // Columns of M, and of M G.
  const Lanes m00 = 2.0 * dot(d.at[0], rate.at[0]), m11 = 2.0 * dot(d.at[1], rate.at[1]),
              m22 = 2.0 * dot(d.at[2], rate.at[2]);
  const Lanes m01 = dot(d.at[0], rate.at[1]) + dot(d.at[1], rate.at[0]);
  const Lanes m02 = dot(d.at[0], rate.at[2]) + dot(d.at[2], rate.at[0]);
  const Lanes m12 = dot(d.at[1], rate.at[2]) + dot(d.at[2], rate.at[1]);
  const Edges y = timesMetric(some, {{{m00, m01, m02}, {m01, m11, m12}, {m02, m12, m22}}});
  const Lanes scale = -law.viscosity_Pa_s * some.volumes_m3;
  Edges forces;
  for (int c = 0; c < 3; ++c)
    forces.at[c] =
        scale * (y.at[c].x * d_metric.at[0] + y.at[c].y * d_metric.at[1] + y.at[c].z * d_metric.at[2]);
  return forces;
}

template <ElementModel model, bool viscous, bool averaged>
void forcesOf(const ElementArrays& arrays, const ElementLaw& law, const ForcePass& pass) {
  for (int group = 0; group < arrays.groups; ++group)
    for (int lane = 0; lane < kLanes; lane += kWidth) {
      const Elements some = elements(arrays, group, lane);
      const Edges d = edges(some, pass.positions_m);
      Lanes pressure = {};
      if constexpr (averaged) {
        for (int c = 0; c < 4; ++c) pressure += gatherNumbers(pass.pressures_Pa, some.corners + kLanes * c);
        pressure *= 0.25;
      }
      if constexpr (model == ElementModel::neo_hookean)
        scatterForces(some, neoHookeanForces(some, law, d, timesMetric(some, d), pressure), pass.forces_N);
      else
        scatterForces(some, stressForces<model>(some, law, d, pressure), pass.forces_N);
      if constexpr (viscous)
        scatterForces(some,
                      viscousForces(some, law, d, timesMetric(some, d), edges(some, pass.velocities_m_s)),
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
    case ElementModel::saint_venant_kirchhoff:
      return forcesOf<ElementModel::saint_venant_kirchhoff>(arrays, law, pass);
    case ElementModel::small_strain:
      return forcesOf<ElementModel::small_strain>(arrays, law, pass);
  }
}

/// Volume strain of all laws but the neo-Hookean one; element_kernels.h states the measure of each.
inline Lanes volumeStrain(const ElementLaw& law, const Matrices& f) {
  if (law.model == ElementModel::small_strain) return f.at[0][0] + f.at[1][1] + f.at[2][2];
  if (law.model == ElementModel::saint_venant_kirchhoff) return 0.5 * (normSquared(f) - 3.0);
  const Matrices cofactor = cofactors(f);
  return rotationTrace(normSquared(f), normSquared(cofactor), determinant(f, cofactor)) - 3.0;
}

void elementVolumeStrains(const ElementArrays& arrays, const ElementLaw& law, const double* positions_m,
                          double* slots) {
  for (int group = 0; group < arrays.groups; ++group)
    for (int lane = 0; lane < kLanes; lane += kWidth) {
      const Elements some = elements(arrays, group, lane);
      const Edges d = edges(some, positions_m);
      Lanes strain;
      if (law.model == ElementModel::neo_hookean) {
        strain = dot(d.at[0], cross(d.at[1], d.at[2])) * load<Lanes>(some.metrics + 6 * kLanes) - 1.0;
      } else {
        const Matrices f = gradient(inverseEdges(some), d);
        strain = volumeStrain(law, f);
      }
      strain *= some.volumes_m3;
      for (int c = 0; c < 4; ++c) scatterNumbers(strain, some.slots + kLanes * c, slots);
    }
}

}  // namespace
}  // namespace fissure
