#include "scenario/deformable.h"

#include <limits>

#include "text/scalars.h"

namespace fissure {

namespace {

/// Bullet's default tolerances: that of btConjugateGradient, which `projection` uses, and that of
/// btConjugateResidual.
constexpr double kStockGradientTolerance = std::numeric_limits<double>::epsilon();
constexpr double kStockResidualTolerance = 1e-8;
constexpr int kStockKrylovIterations = 300;  // btDeformableBodySolver

const DeformableSolver grasp_deformable{.implicit = false,
                                        .line_search = false,
                                        .projection = false,
                                        .newton_iterations = 1,
                                        .newton_tolerance = 1e-4,
                                        .krylov_iterations = kStockKrylovIterations,
                                        .contact_iterations = 150,
                                        .contact_tolerance = 0,
                                        .split_impulse = true,
                                        .error_reduction = 0.1,
                                        .max_error_reduction_m_s = 0.1,
                                        .constraint_mixing = 0};

const DeformableSolver volumetric_deformable{.implicit = true,
                                             .line_search = false,
                                             .projection = true,
                                             .newton_iterations = 1,
                                             .newton_tolerance = 1e-4,
                                             .krylov_iterations = kStockKrylovIterations,
                                             .contact_iterations = 100,
                                             .contact_tolerance = 1e-3,
                                             .split_impulse = true,
                                             .error_reduction = 0.3,
                                             .max_error_reduction_m_s = 200,
                                             .constraint_mixing = 0.01};

const DeformableSolver best_found{.implicit = false,
                                  .line_search = false,
                                  .projection = false,
                                  .newton_iterations = 1,
                                  .newton_tolerance = 1e-4,
                                  .krylov_iterations = kStockKrylovIterations,
                                  .krylov_tolerance = 1e-6,
                                  .contact_iterations = 50,
                                  .contact_tolerance = 0,
                                  .split_impulse = true,
                                  .error_reduction = 0.1,
                                  .max_error_reduction_m_s = 1e-4,
                                  .constraint_mixing = 0};

template <class T>
void fill(std::optional<T>& value, const std::optional<T>& from) {
  if (!value) value = from;
}

std::string textOf(bool value) {
  return value ? "true" : "false";
}
std::string textOf(int value) {
  return std::to_string(value);
}
std::string textOf(double value) {
  return formatReal(value);
}

template <class T>
std::string defaultOf(const std::optional<T> DeformableSolver::*field) {
  const auto text = [&](bool tuned, ElasticMaterialKind material) {
    return textOf(*(withDefaults({}, tuned, material).*field));
  };
  const std::string hookean = text(false, ElasticMaterialKind::neo_hookean),
                    corotated = text(false, ElasticMaterialKind::linear_corotated),
                    tuned = text(true, ElasticMaterialKind::neo_hookean);
  if (hookean == corotated && corotated == tuned) return tuned;
  const std::string stock =
      hookean == corotated ? hookean : hookean + " (neo_hookean) or " + corotated + " (linear_corotated)";
  return "stock " + stock + ", tuned " + tuned;
}

}  // namespace

DeformableSolver withDefaults(const DeformableSolver& solver, bool tuned, ElasticMaterialKind material) {
  const DeformableSolver& from = tuned                                          ? best_found
                                 : material == ElasticMaterialKind::neo_hookean ? grasp_deformable
                                                                                : volumetric_deformable;
  DeformableSolver filled = solver;
  fill(filled.implicit, from.implicit);
  fill(filled.line_search, from.line_search);
  fill(filled.projection, from.projection);
  fill(filled.newton_iterations, from.newton_iterations);
  fill(filled.newton_tolerance, from.newton_tolerance);
  fill(filled.krylov_iterations, from.krylov_iterations);
  fill(filled.krylov_tolerance, from.krylov_tolerance);
  fill(filled.krylov_tolerance,
       std::optional(*filled.projection ? kStockGradientTolerance : kStockResidualTolerance));
  fill(filled.contact_iterations, from.contact_iterations);
  fill(filled.contact_tolerance, from.contact_tolerance);
  fill(filled.split_impulse, from.split_impulse);
  fill(filled.error_reduction, from.error_reduction);
  fill(filled.max_error_reduction_m_s, from.max_error_reduction_m_s);
  fill(filled.constraint_mixing, from.constraint_mixing);
  return filled;
}

std::string deformableDefault(const std::optional<bool> DeformableSolver::*field) {
  return defaultOf(field);
}

std::string deformableDefault(const std::optional<int> DeformableSolver::*field) {
  return defaultOf(field);
}

std::string deformableDefault(const std::optional<double> DeformableSolver::*field) {
  return defaultOf(field);
}

}  // namespace fissure
