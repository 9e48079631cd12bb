#pragma once

// Energy and stretch of all elements for one instruction set. Internal linkage, as in lanes.h.

#include "elastic/lanes_elements.h"

namespace fissure {
namespace {

/// Natural logarithm of normal numbers, to a few units in the last place, from operations that give the same
/// bits on every machine, unlike the C library's.
inline Lanes logarithm(const Lanes& x) {
  constexpr long long kMantissa = 0x000fffffffffffff, kOne = 0x3ff0000000000000, kMagic = 0x4330000000000000;
  const Mask bits = reinterpret_cast<Mask>(x);
  Lanes mantissa = reinterpret_cast<Lanes>((bits & kMantissa) | kOne);
  Lanes exponent = reinterpret_cast<Lanes>((bits >> 52) | kMagic) - (4503599627370496.0 + 1023.0);
  const Mask upper = mantissa > 1.4142135623730951;
  mantissa = upper ? 0.5 * mantissa : mantissa;
  exponent = upper ? exponent + 1.0 : exponent;
  const Lanes s = (mantissa - 1.0) / (mantissa + 1.0), square = s * s;
  Lanes series = all(1.0 / 21);
  for (int n = 19; n >= 1; n -= 2) series = series * square + 1.0 / n;
  return exponent * 0.6931471805599453 + 2.0 * s * series;
}

void elementEnergy(const ElementArrays& arrays, const ElementLaw& law, const double* positions_m,
                   double* energies_J) {
  for (int group = 0; group < arrays.groups; ++group)
    for (int lane = 0; lane < kLanes; lane += kWidth) {
      const Elements some = elements(arrays, group, lane);
      const Matrices f = gradient(some, positions_m), cofactor = cofactors(f);
      const Lanes i = normSquared(f), j = determinant(f, cofactor);
      Lanes density;
      if (law.model == ElementModel::neo_hookean) {
        const Lanes volume = (j - 1.0) * (j + (1 - 2 * law.alpha));  // (J - alpha)^2 - (1 - alpha)^2
        density = 0.5 * (law.mu_Pa * ((i - 3.0) - logarithm(0.25 * larger(i, all(3e-300)) + 0.25)) +
                         law.lambda_Pa * volume);
      } else if (law.model == ElementModel::saint_venant_kirchhoff) {
        // |E|^2 = (|C|^2 - 2 tr C + 3) / 4 with tr C = I and |C|^2 = I^2 - 2 II.
        const Lanes ii = normSquared(cofactor), of_trace = i - 3.0;
        density = 0.25 * law.mu_Pa * (i * i - 2.0 * ii - 2.0 * i + 3.0) +
                  0.125 * law.lambda_Pa * of_trace * of_trace;
      } else {
        const Lanes trace = rotationTrace(i, normSquared(cofactor), j);
        density = law.mu_Pa * (i - 2.0 * trace + 3.0) + 0.5 * law.lambda_Pa * (trace - 3.0) * (trace - 3.0);
      }
      store(load<Lanes>(energies_J + lane) + some.volumes_m3 * density, energies_J + lane);
    }
}

/// Growth of the stiffness of a wave since rest, in the stiffest direction (critical_step.h).
inline Lanes stiffnessGrowth(const ElementLaw& law, const Matrices& f, const Lanes& largest_stretch_squared) {
  const Matrices cofactor = cofactors(f);
  const Lanes i = normSquared(f), ii = normSquared(cofactor), j = determinant(f, cofactor);
  if (law.model == ElementModel::neo_hookean) {
    const Lanes largest_area_squared = largestEigenvalue(ii, j * j * i);
    const Lanes now = law.mu_Pa * (i / (i + 1.0) + 2.0 * largest_stretch_squared / ((i + 1.0) * (i + 1.0))) +
                      law.lambda_Pa * (largest_area_squared +
                                       larger(j - 1.0, all(0)) * squareRoot(largest_stretch_squared));
    return now / (law.mu_Pa * (7.0 / 8) + law.lambda_Pa);
  }
  const double rest_Pa = law.lambda_Pa + 2 * law.mu_Pa;
  if (law.model == ElementModel::saint_venant_kirchhoff) {
    // A wave along n that moves along a, both of length 1, has with v = F^T a the stiffness n.S n + mu (|v|^2
    // + (v.n)^2) + lambda (v.n)^2, where |v| is at most the largest stretch. The stiffest shape of a mesh is
    // not quite that wave, and the stress counts for more in it: up to 1.8 times, in blocks stretched by 1.3.
    const Lanes of_stress = law.mu_Pa * (largest_stretch_squared - 1.0) + 0.5 * law.lambda_Pa * (i - 3.0);
    return (rest_Pa * largest_stretch_squared + 2.0 * larger(of_stress, all(0))) / rest_Pa;
  }
  const Lanes trace = rotationTrace(i, ii, j);
  const Lanes others = larger(trace - squareRoot(largest_stretch_squared), all(1e-3));
  const Lanes of_rotation = larger(law.lambda_Pa * (trace - 3.0) - 2 * law.mu_Pa, all(0)) * 2.0 / others;
  return (rest_Pa + of_rotation) / rest_Pa;
}

void elementStretch(const ElementArrays& arrays, const ElementLaw& law, const double* positions_m,
                    StretchPass& pass) {
  for (int group = 0; group < arrays.groups; ++group)
    for (int lane = 0; lane < kLanes; lane += kWidth) {
      const Elements some = elements(arrays, group, lane);
      const Matrices f = gradient(some, positions_m), cofactor = cofactors(f);
      const Lanes largest_stretch_squared = largestEigenvalue(normSquared(f), normSquared(cofactor));
      const Lanes stiffness = stiffnessGrowth(law, f, largest_stretch_squared);
      const Mask inverted = (determinant(f, cofactor) <= 0.0) & (some.volumes_m3 > 0.0);
      store(larger(stiffness, load<Lanes>(pass.stiffness_growth + lane)), pass.stiffness_growth + lane);
      store(larger(largest_stretch_squared, load<Lanes>(pass.viscous_growth + lane)),
            pass.viscous_growth + lane);
      store(load<Lanes>(pass.inverted + lane) + (inverted ? all(1) : all(0)), pass.inverted + lane);
    }
}

}  // namespace
}  // namespace fissure
