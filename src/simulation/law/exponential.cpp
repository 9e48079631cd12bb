
#include "base/reproducible.h"
#include "law/laws.h"

namespace fissure {

// Fung 1967, Elasticity of soft tissues in simple elongation: stiffness grows in proportion to the force. The
// damper beside it is Kelvin and Voigt's.
ForceLawEntry exponentialLaw() {
  return {.name = "exponential",
          .description = "F = k (exp(a x) - 1) + c x', tissue that stiffens, never pulling (Fung 1967)",
          .fit_formula = "F = F0 + k (exp(a d) - 1) + c d'",
          .coefficients = {{.name = "k",
                            .member = &LawCoefficients::k,
                            .role = CoefficientRole::elastic,
                            .default_value = 0.2,
                            .unit = "N",
                            .units = "newton",
                            .units_per_area = "newton per square metre"},
                           {.name = "a",
                            .member = &LawCoefficients::a,
                            .role = CoefficientRole::shape,
                            .default_value = 100,
                            .unit = "1/m",
                            .units = "per metre",
                            .units_per_area = "per metre"},
                           damperCoefficient()},
          // a d from 0.02 (linear within 1 %) to 30 (the force doubles with every 2.3 % of the depth).
          .shape_search = {.least = 0.02,
                           .largest = 30,
                           .starts = {0.3, 1.0, 3.0, 8.0},
                           .times_deformation = true},
          .force = [](const LawCoefficients& of, double deformation_m, double rate_m_s) -> LawForce {
            if (deformation_m < 0) return {};
            // Without a size there is no force, however far exp() overflows.
            const double elastic_N = of.k == 0 ? 0 : of.k * reproducible::expm1(of.a * deformation_m);
            return withoutAdhesion(elastic_N, of.c * rate_m_s);
          },
          .terms = [](const LawCoefficients& of, double deformation_m, double rate_m_s) -> LawTerms {
            const double growth = reproducible::expm1(of.a * deformation_m);
            return {growth, rate_m_s, rate_m_s / growth};
          }};
}

}  // namespace fissure
