#include "scenario/checker.h"

namespace fissure {

void checkForce(Checker check, const ForceSettings& force) {
  for (const LawCoefficient& coefficient : entryOf(force.model).coefficients) {
    const double value = force.coefficients.*coefficient.member;
    if (coefficient.role == CoefficientRole::shape)
      check.positive(std::string(coefficient.name), value);
    else
      check.notNegative(std::string(coefficient.name), value);
  }
  if (!force.tissue) return;
  check.oneOf("tissue", *force.tissue, catalog().tissues);
  check.require(force.model == ForceModel::hunt_crossley && !force.per_area, "tissue",
                "is given, expected it only for model hunt_crossley without per_area");
}

}  // namespace fissure
