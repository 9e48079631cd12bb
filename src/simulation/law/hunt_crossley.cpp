
#include "base/reproducible.h"
#include "law/laws.h"

namespace fissure {

// Hunt and Crossley 1975; paper, section on the interaction force model.
ForceLawEntry huntCrossleyLaw() {
  return {.name = "hunt_crossley",
          .description = "F = k x^n + lambda x^n x', never pulling (Hunt and Crossley 1975)",
          .fit_formula = "F = F0 + k d^n + lambda d^n d'",
          .coefficients = {{.name = "k",
                            .member = &LawCoefficients::k,
                            .role = CoefficientRole::elastic,
                            .default_value = 200,
                            .unit = "N/m^n",
                            .units = "newton per metre to the power n",
                            .units_per_area = "newton per metre to the power n + 2"},
                           {.name = "lambda",
                            .member = &LawCoefficients::lambda,
                            .role = CoefficientRole::damping,
                            .default_value = 50,
                            .unit = "N s/m^(n+1)",
                            .units = "newton second per metre to the power n + 1",
                            .units_per_area = "newton second per metre to the power n + 3"},
                           {.name = "n",
                            .member = &LawCoefficients::n,
                            .role = CoefficientRole::shape,
                            .default_value = 1.3,
                            .unit = "1",
                            .units = "",
                            .units_per_area = ""}},
          .damping_grows_with_elastic = true,
          .shape_search = {.least = 0.2, .largest = 8, .starts = {1.0, 1.5, 2.2, 3.2}},
          .force = [](const LawCoefficients& of, double deformation_m, double rate_m_s) -> LawForce {
            if (deformation_m <= 0) return {};
            const double power = reproducible::pow(deformation_m, of.n);
            return withoutAdhesion(of.k * power, of.lambda * power * rate_m_s);
          },
          .terms = [](const LawCoefficients& of, double deformation_m, double rate_m_s) -> LawTerms {
            const double power = reproducible::pow(deformation_m, of.n);
            return {power, power * rate_m_s, rate_m_s};
          }};
}

}  // namespace fissure
