#include "law/laws.h"

namespace fissure {

// contact/METHOD.md 12.
ForceLawEntry linearElasticLaw() {
  return {.name = "linear_elastic",
          .description = "F = k x, the default model that the paper replaced",
          .fit_formula = "F = F0 + k d",
          .coefficients = {springCoefficient()},
          .shape_search = {},
          .force = [](const LawCoefficients& of, double deformation_m, double) -> LawForce {
            return deformation_m <= 0 ? LawForce{} : LawForce{of.k * deformation_m, 0, false};
          },
          .terms = [](const LawCoefficients&, double deformation_m, double) -> LawTerms {
            return {deformation_m, 0, 0};
          }};
}

}  // namespace fissure
