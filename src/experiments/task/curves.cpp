#include "task/curves.h"

#include <algorithm>
#include <cstdint>

#include "base/error.h"
#include "base/steps.h"
#include "text/did_you_mean.h"

namespace fissure {

std::vector<CurveQuantity> curveQuantities(const std::vector<std::string>& names, const RecordLayout& layout,
                                           const std::string& where) {
  std::vector<CurveQuantity> known;
  for (const Series& series : layout.series()) {
    if (series.name == "time" || series.name.starts_with("timing/")) continue;
    if (series.axes.empty()) known.push_back({series.name, series.units, series.long_name, false});
    if (series.name == "force" || series.name == "force_elastic" || series.name == "force_viscous")
      known.push_back({series.name, series.units,
                       series.name == "force" ? "magnitude of the force on the tools" : series.long_name,
                       true});
  }
  if (layout.find("tool_position") && layout.find("contact_count"))
    known.push_back({"indentation", "m", "way of the first tool since it first touched tissue", false});
  std::vector<std::string> choices;
  for (const CurveQuantity& quantity : known) choices.push_back(quantity.name);
  std::vector<CurveQuantity> found;
  for (const std::string& name : names) {
    const auto is = [&](const CurveQuantity& quantity) { return quantity.name == name; };
    const auto at = std::find_if(known.begin(), known.end(), is);
    if (at == known.end())
      throw InputError(std::string(where)
                           .append(": no quantity \"")
                           .append(name)
                           .append("\" with one value a step")
                           .append(didYouMean(name, choices)));
    if (std::any_of(found.begin(), found.end(), is))
      throw InputError(
          std::string(where).append(": \"").append(name).append("\" twice, expected each quantity once"));
    found.push_back(*at);
  }
  return found;
}

std::vector<double> curveTimes_s(const SweepCurves& curves) {
  std::vector<double> times_s;
  const auto last = static_cast<std::int64_t>(intervalsIn(*curves.until_s, curves.every_s));
  for (std::int64_t i = 0; i <= last; ++i) times_s.push_back(static_cast<double>(i) * curves.every_s);
  return times_s;
}

}  // namespace fissure
