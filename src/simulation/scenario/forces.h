#pragma once

#include <optional>
#include <string>
#include <vector>

#include "law/deformation.h"
#include "law/force_law.h"
#include "scenario/catalog.h"
#include "scenario/key.h"

namespace fissure {

/// One entry of `force:`: a force law that is evaluated in every step of every run (contact/METHOD.md 12).
/// F(x, x') is summed over the triangles in a colliding state. With `per_area` F is a pressure and is
/// multiplied by the triangle's area at rest; the factors of the law's terms are then per square metre and
/// have no default.
struct ForceSettings {
  std::string name;
  ForceModel model = ForceModel::hunt_crossley;
  /// Coefficients that the law does not have keep their initial values. The defaults are those of `model` at
  /// construction: code that changes the model later must set them too.
  LawCoefficients coefficients = entryOf(model).defaults();
  /// Differences are the default because with response none the engine's velocities of held tissue have no
  /// meaning (tens of m/s at rest).
  RateSource rate = RateSource::differences;
  DeformationKind deformation = DeformationKind::paper;
  bool per_area = false;
  /// A name in catalog().tissues (scenario/tissues.h says what its numbers are worth).
  std::optional<std::string> tissue;

  bool operator==(const ForceSettings&) const = default;
};

/// The documentation of a coefficient that one or more laws have.
struct CoefficientText {
  std::string name;
  double LawCoefficients::*member = nullptr;
  CoefficientRole role = CoefficientRole::elastic;
  std::string doc;
  /// "N/m^n (hunt_crossley), N/m (kelvin_voigt, linear_elastic)".
  std::string unit;
  /// "200 (hunt_crossley, kelvin_voigt); required with per_area".
  std::string defaults;
};

/// The documentation of all coefficients, in the order of allCoefficients().
const std::vector<CoefficientText>& coefficientTexts();

/// Sets k, n and lambda of a Hunt-Crossley law to those of its `tissue`; changes nothing without a tissue or
/// with an unknown one.
void applyTissue(ForceSettings& law);

template <class Io>
void describe(Io& io, ForceSettings& f) {
  io.field("name", f.name,
           Key("Name of the law, once in the scenario; it is part of the names of its results.")
               .itemName()
               .sameAs("model"));
  io.field("model", f.model,
           Key("The force law F(x, x'), x being how far a triangle's centroid was displaced and x' its rate; "
               "F is summed over the triangles in a colliding state.")
               .oneOf(catalog().force_laws)
               .required());
  io.field("deformation", f.deformation,
           Key("What a triangle is compared with to get x.").oneOf(catalog().deformations));
  io.field("per_area", f.per_area,
           Key("Whether the law is a pressure, times the area of the triangle at rest: the total then "
               "converges as the mesh is refined, else it grows with the number of triangles. Sizes of terms "
               "are then per square metre, and required."));
  io.field(
      "tissue", f.tissue,
      Key("A measured tissue, which sets k, n and lambda where the file leaves them out. Its exponent is the "
          "tissue's; the size of its force is that of a whole probe, not of a sum over triangles.")
          .oneOf(catalog().tissues)
          .otherwise("none")
          .onlyIf(f.model == ForceModel::hunt_crossley && !f.per_area,
                  "model hunt_crossley without per_area"));
  const ForceLawEntry& law = entryOf(f.model);
  io.whileReading([&] {
    f.coefficients = law.defaults();
    applyTissue(f);
  });
  for (const CoefficientText& of : coefficientTexts()) {
    const LawCoefficient* own = law.find(of.name);
    Key key(of.doc.c_str());
    if (of.role == CoefficientRole::shape)
      key.above(0);
    else
      key.atLeast(0);
    // A default in other units would mean nothing.
    key.required(own && of.role != CoefficientRole::shape && f.per_area);
    io.field(of.name.c_str(), f.coefficients.*of.member,
             key.unit(of.unit).otherwise(of.defaults).onlyIf(own != nullptr, modelsWith(of.name)));
  }
  io.field(
      "rate", f.rate,
      Key("Where x' comes from. The engine's velocities of held tissue have no meaning with response none.")
          .oneOf(catalog().rates)
          .onlyIf(law.find(CoefficientRole::damping) != nullptr, modelsWith(CoefficientRole::damping)));
}

}  // namespace fissure
