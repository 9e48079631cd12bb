#pragma once

#include <optional>
#include <string>

#include "scenario/elastic.h"

namespace fissure {

/// The parts of tissue that Bullet's deformable world tests against tools.
enum class DeformableContacts {
  nodes,  ///< vertices, in the tool's signed distance field (SDF_RDN)
  faces,  ///< surface triangles, by GJK (SDF_RDF)
};

/// Settings of Bullet's deformable world (engine/METHOD.md 5). No value: the default for the entry's
/// `settings` and the body's material (withDefaults()).
struct DeformableSolver {
  std::optional<int> substeps;
  std::optional<bool> implicit;
  std::optional<bool> line_search;
  std::optional<bool> projection;
  std::optional<int> newton_iterations;
  std::optional<double> newton_tolerance;
  std::optional<int> krylov_iterations;
  std::optional<double> krylov_tolerance;
  std::optional<int> contact_iterations;
  std::optional<double> contact_tolerance;
  std::optional<bool> split_impulse;
  std::optional<double> error_reduction;
  std::optional<double> max_error_reduction_m_s;
  std::optional<double> constraint_mixing;

  bool operator==(const DeformableSolver&) const = default;
};

/// Returns `solver` with defaults in all unset fields but substeps. The stock defaults are those of Bullet's
/// own examples with this material: GraspDeformable (neo-Hookean, explicit) and VolumetricDeformable (linear,
/// implicit). The tuned ones kept tools out of tissue best on configs/elastic_press.yaml: explicit for both
/// materials, because the implicit solve diverges beyond small steps (results/deformable).
DeformableSolver withDefaults(const DeformableSolver& solver, bool tuned, ElasticMaterialKind material);

/// The default of one field in words: "stock 150 (neo_hookean) or 100 (linear_corotated), tuned 50".
std::string deformableDefault(const std::optional<bool> DeformableSolver::*field);
std::string deformableDefault(const std::optional<int> DeformableSolver::*field);
std::string deformableDefault(const std::optional<double> DeformableSolver::*field);

template <class Io>
void describe(Io& io, DeformableSolver& s) {
  using S = DeformableSolver;
  const auto of = [](auto field) { return deformableDefault(field); };
  io.field("substeps", s.substeps,
           Key("Steps of Bullet in one of the scenario, tools between their poses.")
               .count(1, 10000)
               .otherwise("stock: steps of at most 1/240 s, as in Bullet's examples; tuned: as many as the "
                          "explicit engine would take, so that they rise while elements are stretched"));
  io.field("implicit", s.implicit,
           Key("Whether elastic forces are those of the step's end, else of its start [setImplicit].")
               .otherwise(of(&S::implicit)));
  io.field("line_search", s.line_search,
           Key("Line search of Newton's method [setLineSearch]; with `implicit` alone.")
               .otherwise(of(&S::line_search)));
  io.field("projection", s.projection,
           Key("Conjugate gradients on what contacts leave free, else conjugate residuals with Lagrange "
               "multipliers [setUseProjection].")
               .otherwise(of(&S::projection)));
  io.field("newton_iterations", s.newton_iterations,
           Key("Iterations of Newton's method in a step; with `implicit` alone.")
               .count(1, 1000)
               .otherwise(of(&S::newton_iterations)));
  io.field("newton_tolerance", s.newton_tolerance,
           Key("Norm of the residual at which Newton's method ends; with `implicit` alone.")
               .unit("N s")
               .atLeast(0)
               .otherwise(of(&S::newton_tolerance)));
  io.field("krylov_iterations", s.krylov_iterations,
           Key("Iterations of the linear solver.").count(1, 100000).otherwise(of(&S::krylov_iterations)));
  io.field("krylov_tolerance", s.krylov_tolerance,
           Key("Tolerance of the linear solver.").noUnit().atLeast(0).otherwise(of(&S::krylov_tolerance)));
  io.field("contact_iterations", s.contact_iterations,
           Key("Gauss-Seidel iterations over the contacts [m_numIterations].")
               .count(1, 10000)
               .otherwise(of(&S::contact_iterations)));
  io.field("contact_tolerance", s.contact_tolerance,
           Key("Residual of the contacts at which their iterations end [m_leastSquaresResidualThreshold].")
               .unit("m2/s2")
               .atLeast(0)
               .otherwise(of(&S::contact_tolerance)));
  io.field("split_impulse", s.split_impulse,
           Key("Whether overlap is taken back without velocity [m_splitImpulse].")
               .otherwise(of(&S::split_impulse)));
  io.field(
      "error_reduction", s.error_reduction,
      Key("Share of an overlap that is taken back in a step [m_deformable_erp]; more makes contacts rattle.")
          .share()
          .otherwise(of(&S::error_reduction)));
  io.field("max_error_reduction_m_s", s.max_error_reduction_m_s,
           Key("How fast overlap is taken back at most [m_deformable_maxErrorReduction].")
               .above(0)
               .otherwise(of(&S::max_error_reduction_m_s)));
  io.field("constraint_mixing", s.constraint_mixing,
           Key("Softness of contacts [m_deformable_cfm].").share().otherwise(of(&S::constraint_mixing)));
}

}  // namespace fissure
