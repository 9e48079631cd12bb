#pragma once

#include <optional>

#include "scenario/elastic.h"

namespace fissure {

/// What of the tissue Bullet's deformable world tests against tools.
enum class DeformableContacts {
  nodes,  ///< vertices, in the tool's signed distance field (SDF_RDN)
  faces,  ///< surface triangles, by GJK (SDF_RDF)
};

/// Settings of Bullet's deformable world. No value: as `settings` of the entry and the body's material say
/// (withDefaults()).
struct DeformableSolver {
  /// Steps of Bullet in one of the scenario, tools between their poses, 1..10000. No value: with stock
  /// settings of at most 1/240 s, as in Bullet's examples; with tuned ones as many as the explicit engine
  /// would take, so that they rise while elements are stretched.
  std::optional<int> substeps;
  std::optional<bool> implicit;     ///< setImplicit: elastic forces of the step's end; else of its start
  std::optional<bool> line_search;  ///< setLineSearch, of Newton's method; implicit alone
  /// setUseProjection: conjugate gradients on what contacts leave free; else conjugate residuals with
  /// Lagrange multipliers.
  std::optional<bool> projection;
  std::optional<int> newton_iterations;           ///< 1..1000; implicit alone
  std::optional<double> newton_tolerance;         ///< of the residual's norm, N s, >= 0; implicit alone
  std::optional<int> krylov_iterations;           ///< of the linear solver, 1..100000
  std::optional<double> krylov_tolerance;         ///< of the linear solver, >= 0
  std::optional<int> contact_iterations;          ///< m_numIterations, 1..10000
  std::optional<double> contact_tolerance;        ///< m_leastSquaresResidualThreshold, m2/s2, >= 0
  std::optional<bool> split_impulse;              ///< m_splitImpulse: overlap is taken back without velocity
  std::optional<double> error_reduction;          ///< m_deformable_erp: share of an overlap taken back, 0..1
  std::optional<double> max_error_reduction_m_s;  ///< m_deformable_maxErrorReduction, > 0
  std::optional<double> constraint_mixing;        ///< m_deformable_cfm, 0..1

  bool operator==(const DeformableSolver&) const = default;
};

/// `solver` with every field but substeps filled in. Stock is what Bullet's own examples of the material
/// have: GraspDeformable (neo-Hookean, explicit) and VolumetricDeformable (linear, implicit). Tuned is what
/// held best on configs/elastic_press.yaml: explicit for both, since beyond small steps the implicit solve
/// diverges (results/deformable).
DeformableSolver withDefaults(const DeformableSolver& solver, bool tuned, ElasticMaterialKind material);

}  // namespace fissure
