#pragma once

#include "law/force_law.h"

namespace fissure {

// One entry per law, each in a file of its own; forceLaws() is their table.
ForceLawEntry huntCrossleyLaw();
ForceLawEntry kelvinVoigtLaw();
ForceLawEntry linearElasticLaw();
ForceLawEntry exponentialLaw();

// Coefficients that several laws share.

/// The coefficient k of a linear spring, N/m.
inline LawCoefficient springCoefficient() {
  return {.name = "k",
          .member = &LawCoefficients::k,
          .role = CoefficientRole::elastic,
          .default_value = 200,
          .unit = "N/m",
          .units = "newton per metre",
          .units_per_area = "newton per cubic metre"};
}

/// The coefficient c of a damper parallel to the elastic term, N s/m.
inline LawCoefficient damperCoefficient() {
  return {.name = "c",
          .member = &LawCoefficients::c,
          .role = CoefficientRole::damping,
          .default_value = 1,
          .unit = "N s/m",
          .units = "newton second per metre",
          .units_per_area = "newton second per cubic metre"};
}

}  // namespace fissure
