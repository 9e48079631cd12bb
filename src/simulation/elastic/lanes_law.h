#pragma once

// Invariants of the deformation gradient F and the stresses, per lane. Internal linkage, as in lanes.h.

#include "elastic/element_kernels.h"
#include "elastic/lanes.h"

namespace fissure {
namespace {

/// A 3x3 matrix per lane, row by row.
struct Matrices {
  Lanes at[3][3];
};

inline Matrices cofactors(const Matrices& f) {
  Matrices c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c.at[i][j] = f.at[i1][j1] * f.at[i2][j2] - f.at[i1][j2] * f.at[i2][j1];
    }
  return c;
}

inline Lanes normSquared(const Matrices& m) {
  Lanes sum = m.at[0][0] * m.at[0][0];
  for (int k = 1; k < 9; ++k) sum += m.at[k / 3][k % 3] * m.at[k / 3][k % 3];
  return sum;
}

inline Lanes determinant(const Matrices& f, const Matrices& cofactor) {
  return f.at[0][0] * cofactor.at[0][0] + f.at[0][1] * cofactor.at[0][1] + f.at[0][2] * cofactor.at[0][2];
}

/// Upper bound of the largest eigenvalue of a symmetric 3x3 matrix from its trace and second invariant (the
/// sum of products of two eigenvalues); exact where the other two are equal (Wolkowicz, Styan 1980).
inline Lanes largestEigenvalue(const Lanes& trace, const Lanes& second_invariant) {
  const Lanes spread = larger(trace * trace - 3.0 * second_invariant, all(0));
  return trace / 3.0 + 2.0 / 3.0 * squareRoot(spread);
}

/// Largest value of tr(Q^T F) over all rotations Q: the sum of the singular values of F, the smallest with
/// the sign of det F. It is the largest root of x^4 - 2 I x^2 - 8 J x + I^2 - 4 II with I = |F|^2, II = |cof
/// F|^2, J = det F (Horn 1987; Theobald 2005). Newton's method descends to it from sqrt(3 I); a lane that has
/// converged is not changed any more, so that no lane depends on its neighbours.
inline Lanes rotationTrace(const Lanes& i, const Lanes& ii, const Lanes& j) {
  const Lanes constant = i * i - 4.0 * ii;
  Lanes x = squareRoot(3.0 * i);
  for (int round = 0; round < 60; ++round) {
    const Lanes square = x * x;
    const Lanes value = ((square - 2.0 * i) * x - 8.0 * j) * x + constant;
    const Lanes slope = larger(4.0 * ((square - i) * x - 2.0 * j), all(1e-300));
    const Lanes next = x - value / slope;
    const Mask falls = next < x * (1 - 4e-16);
    if (!any(falls)) break;
    x = falls ? next : x;
  }
  return x;
}

/// The rotation nearest to F: the derivative of rotationTrace by F. Where the two smaller singular values of
/// an inverted F are equal no rotation is nearest, and close to there the result falls below a rotation.
inline Matrices nearestRotation(const Matrices& f, const Matrices& cofactor, const Lanes& trace) {
  const Lanes i = normSquared(f), j = determinant(f, cofactor);
  const Lanes cube = trace * trace * trace;
  const Lanes scale = 1.0 / larger(cube - i * trace - 2.0 * j, 1e-9 * cube + 1e-300);
  const Lanes of_f = (trace * trace + i) * scale, of_cofactor = 2.0 * trace * scale,
              of_product = -2.0 * scale;
  Lanes c[3][3];  // F^T F
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      c[a][b] = c[b][a] = f.at[0][a] * f.at[0][b] + f.at[1][a] * f.at[1][b] + f.at[2][a] * f.at[2][b];
  Matrices r;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const Lanes product = f.at[a][0] * c[0][b] + f.at[a][1] * c[1][b] + f.at[a][2] * c[2][b];
      r.at[a][b] = of_f * f.at[a][b] + of_cofactor * cofactor.at[a][b] + of_product * product;
    }
  return r;
}

/// First Piola-Kirchhoff stress of all laws but the neo-Hookean one (material.h); `pressure` is that of nodal
/// averages.
template <ElementModel model>
inline Matrices stress(const Matrices& f, const ElementLaw& law, const Lanes& pressure) {
  Matrices p;
  if constexpr (model == ElementModel::small_strain) {
    const Lanes of_volume = law.lambda_Pa * (f.at[0][0] + f.at[1][1] + f.at[2][2]) + pressure;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) p.at[a][b] = law.mu_Pa * (f.at[a][b] + f.at[b][a]);
    for (int a = 0; a < 3; ++a) p.at[a][a] += of_volume;
  } else if constexpr (model == ElementModel::saint_venant_kirchhoff) {
    Lanes s[3][3];  // second Piola-Kirchhoff stress
    for (int a = 0; a < 3; ++a)
      for (int b = a; b < 3; ++b)
        s[a][b] = s[b][a] =
            law.mu_Pa * (f.at[0][a] * f.at[0][b] + f.at[1][a] * f.at[1][b] + f.at[2][a] * f.at[2][b]);
    const Lanes of_volume = 0.5 * law.lambda_Pa * (normSquared(f) - 3.0) - law.mu_Pa + pressure;
    for (int a = 0; a < 3; ++a) s[a][a] += of_volume;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        p.at[a][b] = f.at[a][0] * s[0][b] + f.at[a][1] * s[1][b] + f.at[a][2] * s[2][b];
  } else {
    const Matrices cofactor = cofactors(f);
    const Lanes trace = rotationTrace(normSquared(f), normSquared(cofactor), determinant(f, cofactor));
    const Matrices rotation = nearestRotation(f, cofactor, trace);
    const Lanes of_rotation = law.lambda_Pa * (trace - 3.0) - 2 * law.mu_Pa + pressure;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) p.at[a][b] = 2 * law.mu_Pa * f.at[a][b] + of_rotation * rotation.at[a][b];
  }
  return p;
}

}  // namespace
}  // namespace fissure
