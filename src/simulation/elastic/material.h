#pragma once

#include <cstddef>
#include <vector>

namespace fissure {

/// Hyperelastic laws of a tissue (elastic/METHOD.md 2). All have the Young's modulus and Poisson's ratio of
/// the material at small strains. F is the deformation gradient, P the first Piola-Kirchhoff stress; lambda
/// and mu are the Lame constants.
enum class MaterialModel {
  /// Stable neo-Hookean law with its log term (Smith, de Goes, Kim 2018): P = mu' (1 - 1 / (I_C + 1)) F
  /// + lambda' (J - alpha) cof F, mu' = 4/3 mu, lambda' = lambda + 5/6 mu,
  /// alpha = 1 + 3 mu' / (4 lambda').
  neo_hookean,
  /// Corotated linear elasticity: P = 2 mu (F - R) + lambda (tr(R^T F) - 3) R with the rotation R nearest to
  /// F, which is a proper rotation for inverted elements too. For moderate strains: under compression it
  /// loses its resistance to shear (its ellipticity) where all stretches s have 2 mu (2 s - 1) < 3 lambda (1
  /// - s), that is, at volume ratios below 0.67 for a Poisson's ratio of 0.4 and below 0.96 for 0.49; there
  /// its elements buckle.
  linear_corotated,
  /// Hooke's law between the Green strain E and the second Piola-Kirchhoff stress: P = F (2 mu E + lambda
  /// tr(E) I). It is the law that most finite-element programs use with an elastic modulus and large
  /// displacements, and so the one to compare with them. It stiffens in tension. Compressed along one axis
  /// its force falls again below a stretch of 1 / sqrt(3); compressed from all sides it loses its resistance
  /// to shear below a stretch of sqrt((2 mu + 3 lambda) / (4 mu + 3 lambda)), a volume ratio of 0.82 at a
  /// Poisson's ratio of 0.4. Inverted elements are not driven back.
  saint_venant_kirchhoff,
};

/// An isotropic hyperelastic material with damping.
struct ElasticMaterial {
  MaterialModel model = MaterialModel::neo_hookean;
  double youngs_modulus_Pa = 0;  ///< above 0
  double poissons_ratio = 0;     ///< from 0, below 0.5
  double density_kg_m3 = 0;      ///< above 0
  /// Viscosity eta of the viscous second Piola-Kirchhoff stress 2 eta dE/dt with the Green strain E
  /// (elastic/METHOD.md 4). Rotations cause no such stress, and momentum and angular momentum are conserved.
  /// Shear at small strains has the viscosity eta.
  double viscosity_Pa_s = 0;
  /// Deceleration over velocity; it acts on rigid motion of the body too (elastic/METHOD.md 4).
  double mass_damping_1_s = 0;

  bool operator==(const ElasticMaterial&) const = default;
};

/// The material of each element of a tissue. All materials must have the same model and mass damping.
struct ElementMaterials {
  std::vector<ElasticMaterial> materials;  ///< at least one
  std::vector<int> of_elements;            ///< [tetrahedron] index of its material; empty: all 0
};

/// The same assignment with equal materials merged and unused ones removed; their order is kept. Throws
/// std::invalid_argument, with one line, where a material is not valid, where materials differ in model or
/// mass damping, or where `of_elements` does not have one valid index for each of the `elements` tetrahedra.
ElementMaterials distinctMaterials(const ElementMaterials& given, std::size_t elements);

/// Lame constants of a material, pascals.
struct LameConstants {
  double lambda_Pa = 0;
  double mu_Pa = 0;
};

LameConstants lameConstants(double youngs_modulus_Pa, double poissons_ratio);

/// Throws std::invalid_argument, with one line, where a value is outside its range.
void checkMaterial(const ElasticMaterial& material);

}  // namespace fissure
