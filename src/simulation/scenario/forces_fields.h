#pragma once

#include <string>

#include "scenario/catalog.h"
#include "scenario/forces.h"
#include "scenario/tissues.h"

namespace fissure {

// The keys of an entry of `force:` (scenario/fields.h says how keys are described).

template <class Io>
void describe(Io& io, ForceSettings& f) {
  io.nameOr("name", f.name, "model");
  io.requiredChoice("model", f.model, catalog().force_laws);
  io.choice("deformation", f.deformation, catalog().deformations);
  io.field("per_area", f.per_area);
  io.choiceIf(f.model == ForceModel::hunt_crossley && !f.per_area, "model hunt_crossley without per_area",
              "tissue", f.tissue, catalog().tissues);
  const ForceLawEntry& law = entryOf(f.model);
  io.whileReading([&] {
    f.coefficients = law.defaults();
    applyTissue(f);
  });
  for (const CoefficientName& of : allCoefficients()) {
    const LawCoefficient* own = law.find(of.name);
    double& value = f.coefficients.*of.member;
    const std::string key(of.name);
    if (own && own->role != CoefficientRole::shape && f.per_area)
      io.required(key.c_str(), value);  // a default in other units would mean nothing
    else
      io.fieldIf(own != nullptr, modelsWith(of.name).c_str(), key.c_str(), value);
  }
  io.choiceIf(law.find(CoefficientRole::damping) != nullptr, modelsWith(CoefficientRole::damping).c_str(),
              "rate", f.rate, catalog().rates);
}

}  // namespace fissure
