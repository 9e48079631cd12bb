#include "scenario/forces.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "text/scalars.h"

namespace fissure {

namespace {

std::string docOf(CoefficientRole role) {
  const std::string formula = ", as the formula of `model` has it.";
  if (role == CoefficientRole::elastic) return "Size of the law's elastic term" + formula;
  if (role == CoefficientRole::damping) return "Size of the law's damping term" + formula;
  return "How fast the law's elastic term grows with the deformation" + formula;
}

/// What `textOf` says of a coefficient in each law that has it, equal texts once: "200 (a, b), 0.2 (c)".
std::string perLaw(std::string_view name, const std::function<std::string(const LawCoefficient&)>& textOf) {
  std::vector<std::pair<std::string, std::string>> texts;  // and the laws
  for (const ForceLawEntry& law : forceLaws()) {
    const LawCoefficient* of = law.find(name);
    if (!of) continue;
    const std::string text = textOf(*of);
    const auto same =
        std::find_if(texts.begin(), texts.end(), [&](const auto& one) { return one.first == text; });
    if (same == texts.end())
      texts.emplace_back(text, law.name);
    else
      same->second.append(", ").append(law.name);
  }
  if (texts.size() == 1) return texts[0].first;
  std::string joined;
  for (const auto& [text, laws] : texts) joined += (joined.empty() ? "" : ", ") + text + " (" + laws + ")";
  return joined;
}

}  // namespace

const std::vector<CoefficientText>& coefficientTexts() {
  static const std::vector<CoefficientText> all = [] {
    std::vector<CoefficientText> made;
    for (const CoefficientName& of : allCoefficients()) {
      CoefficientText text{std::string(of.name), of.member};
      for (const ForceLawEntry& law : forceLaws())
        if (const LawCoefficient* own = law.find(of.name)) text.role = own->role;
      const bool is_size = text.role != CoefficientRole::shape;
      text.doc = docOf(text.role);
      text.unit = perLaw(of.name, [](const LawCoefficient& own) {
        return own.unit == "1" ? std::string("none") : std::string(own.unit);
      });
      if (is_size) text.unit += "; per m2 of tissue with per_area";
      text.defaults =
          perLaw(of.name, [](const LawCoefficient& own) { return formatReal(own.default_value); });
      if (text.member == &LawCoefficients::k || text.member == &LawCoefficients::lambda ||
          text.member == &LawCoefficients::n)
        text.defaults += ", unless `tissue` says another";
      if (is_size) text.defaults += "; required with per_area";
      made.push_back(std::move(text));
    }
    return made;
  }();
  return all;
}

}  // namespace fissure
