#pragma once

#include <cstddef>
#include <vector>

namespace fissure {

/// Hyperelastic laws of a tissue. Both have the Young's modulus and Poisson's ratio of the material at small
/// strains; with F the deformation gradient, P the first Piola-Kirchhoff stress and lambda, mu the Lame
/// constants:
enum class MaterialModel {
  /// Stable neo-Hookean law with its log term (Smith, de Goes, Kim 2018): P = mu' (1 - 1 / (I_C + 1)) F
  /// + lambda' (J - alpha) cof F, mu' = 4/3 mu, lambda' = lambda + 5/6 mu,
  /// alpha = 1 + 3 mu' / (4 lambda').
  neo_hookean,
  /// Corotated linear elasticity: P = 2 mu (F - R) + lambda (tr(R^T F) - 3) R with the rotation R nearest to
  /// F, which is a proper rotation for inverted elements too. For moderate strains: compressed, it loses its
  /// resistance to shear (its ellipticity) where all stretches s have 2 mu (2 s - 1) < 3 lambda (1 - s), so
  /// at
  /// volumes below 0.67 for a Poisson's ratio of 0.4, and 0.96 for 0.49; there its elements buckle.
  linear_corotated,
};

struct ElasticMaterial {
  MaterialModel model = MaterialModel::neo_hookean;
  double youngs_modulus_Pa = 0;  ///< above 0
  double poissons_ratio = 0;     ///< from 0, below 0.5
  double density_kg_m3 = 0;      ///< above 0
  /// Of the viscous second Piola-Kirchhoff stress 2 eta dE/dt, E the Green strain: a rotation is free of it,
  /// and it conserves momentum and angular momentum. Shear at small strains has the viscosity eta.
  double viscosity_Pa_s = 0;
  /// Deceleration over velocity. It acts on the motion of the body as a whole too.
  double mass_damping_1_s = 0;

  bool operator==(const ElasticMaterial&) const = default;
};

/// What each element of a tissue consists of. All materials have one model and one mass damping.
struct ElementMaterials {
  std::vector<ElasticMaterial> materials;  ///< at least one
  std::vector<int> of_elements;            ///< one a tetrahedron: its material; empty: all the first
};

/// The same with each material once, in their order, and only those that an element has. Throws
/// std::invalid_argument, with one line, where one is not valid, they do not agree, or `of_elements` is not
/// one material for each of `elements`.
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
