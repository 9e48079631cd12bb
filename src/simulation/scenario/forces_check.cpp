#include "scenario/checker.h"

namespace fissure {

void checkForce(Checker check, const ForceSettings& force) {
  if (!force.tissue) return;
  check.require(force.model == ForceModel::hunt_crossley && !force.per_area, "tissue",
                "is given, expected it only for model hunt_crossley without per_area");
}

}  // namespace fissure
