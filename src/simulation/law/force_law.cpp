#include "law/force_law.h"

#include <algorithm>
#include <functional>

#include "law/laws.h"
#include "text/lists.h"

namespace fissure {

namespace {

std::string modelsFor(const std::function<bool(const ForceLawEntry&)>& applies) {
  std::vector<std::string_view> names;
  for (const ForceLawEntry& law : forceLaws())
    if (applies(law)) names.push_back(law.name);
  return withNoun("model", names);
}

}  // namespace

const std::vector<ForceLawEntry>& forceLaws() {
  static const std::vector<ForceLawEntry> table = {huntCrossleyLaw(), kelvinVoigtLaw(), linearElasticLaw(),
                                                   exponentialLaw()};
  return table;
}

const ForceLawEntry& entryOf(ForceModel model) {
  return forceLaws().at(static_cast<std::size_t>(model));
}

std::optional<ForceModel> modelNamed(std::string_view name) {
  for (std::size_t i = 0; i < forceLaws().size(); ++i)
    if (forceLaws()[i].name == name) return static_cast<ForceModel>(i);
  return std::nullopt;
}

const LawCoefficient* ForceLawEntry::find(CoefficientRole role) const {
  const auto found = std::find_if(coefficients.begin(), coefficients.end(),
                                  [&](const LawCoefficient& of) { return of.role == role; });
  return found == coefficients.end() ? nullptr : &*found;
}

const LawCoefficient* ForceLawEntry::find(std::string_view coefficient) const {
  const auto found = std::find_if(coefficients.begin(), coefficients.end(),
                                  [&](const LawCoefficient& of) { return of.name == coefficient; });
  return found == coefficients.end() ? nullptr : &*found;
}

LawCoefficients ForceLawEntry::defaults() const {
  LawCoefficients values;
  for (const LawCoefficient& coefficient : coefficients)
    values.*coefficient.member = coefficient.default_value;
  return values;
}

const std::vector<CoefficientName>& allCoefficients() {
  static const std::vector<CoefficientName> all = [] {
    std::vector<CoefficientName> made;
    for (const ForceLawEntry& law : forceLaws())
      for (const LawCoefficient& coefficient : law.coefficients)
        if (std::none_of(made.begin(), made.end(),
                         [&](const CoefficientName& known) { return known.name == coefficient.name; }))
          made.push_back({coefficient.name, coefficient.member});
    return made;
  }();
  return all;
}

std::string modelsWith(std::string_view coefficient) {
  return modelsFor([&](const ForceLawEntry& law) { return law.find(coefficient) != nullptr; });
}

std::string modelsWith(CoefficientRole role) {
  return modelsFor([&](const ForceLawEntry& law) { return law.find(role) != nullptr; });
}

}  // namespace fissure
