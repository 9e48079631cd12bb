#include "law/laws.h"

namespace fissure {

// contact/METHOD.md 12.
ForceLawEntry kelvinVoigtLaw() {
  return {.name = "kelvin_voigt",
          .description = "F = k x + c x', a spring and a damper side by side, never pulling",
          .fit_formula = "F = F0 + k d + c d'",
          .coefficients = {springCoefficient(), damperCoefficient()},
          .shape_search = {},
          .force = [](const LawCoefficients& of, double deformation_m, double rate_m_s) -> LawForce {
            if (deformation_m < 0) return {};
            return withoutAdhesion(of.k * deformation_m, of.c * rate_m_s);
          },
          .terms = [](const LawCoefficients&, double deformation_m, double rate_m_s) -> LawTerms {
            return {deformation_m, rate_m_s, rate_m_s / deformation_m};
          }};
}

}  // namespace fissure
