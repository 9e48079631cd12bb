#include "task/task_order.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace fissure {

namespace {

using nlohmann::json;

json lawsJson(const std::vector<std::vector<ForceSettings>>& rows) {
  json numbers = json::array();
  for (const auto& row : rows)
    for (const ForceSettings& law : row)
      for (const CoefficientName& of : allCoefficients()) numbers.push_back(law.coefficients.*of.member);
  return numbers;
}

std::vector<std::vector<ForceSettings>> readLaws(const json& numbers, std::size_t laws) {
  std::vector<std::vector<ForceSettings>> rows;
  for (std::size_t at = 0; at < numbers.size();) {
    std::vector<ForceSettings>& row = rows.emplace_back(laws);
    for (ForceSettings& law : row)
      for (const CoefficientName& of : allCoefficients()) law.coefficients.*of.member = numbers.at(at++);
  }
  return rows;
}

}  // namespace

InputError aboutAxis(const InputError& error) {
  if (error.origin().kind != Origin::Kind::override) return error;
  return {ofAxis(error.origin().path), error.text()};
}

std::string orderText(const TaskOrder& order) {
  json text = {{"name", order.name},
               {"scenario", order.scenario},
               {"directory", order.directory.string()},
               {"pipeline", order.pipeline},
               {"set", json::array()},
               {"frames", order.frames},
               {"laws", order.laws.empty() ? 0 : order.laws.front().size()},
               {"coefficients", lawsJson(order.laws)}};
  for (const Override& override : order.overrides) text["set"].push_back({override.path, override.value});
  if (order.curves)
    text["curves"] = {{"quantities", order.curves->quantities},
                      {"every_s", order.curves->every_s},
                      {"until_s", order.curves->until_s.value()}};
  return text.dump();
}

TaskOrder parseOrder(const std::string& text) {
  try {
    const json from = json::parse(text);
    TaskOrder order{from.at("name"),
                    from.at("scenario"),
                    from.at("directory").get<std::string>(),
                    {},
                    from.at("pipeline"),
                    readLaws(from.at("coefficients"), from.at("laws")),
                    {},
                    from.at("frames")};
    for (const json& pair : from.at("set")) order.overrides.push_back({pair.at(0), pair.at(1)});
    if (!from.contains("curves")) return order;
    const json& curves = from.at("curves");
    order.curves.emplace();
    order.curves->quantities = curves.at("quantities").get<std::vector<std::string>>();
    order.curves->every_s = curves.at("every_s");
    order.curves->until_s = curves.at("until_s").get<double>();
    return order;
  } catch (const json::exception& error) {
    throw InputError(std::string("no order of a sweep: ") + error.what());
  }
}

}  // namespace fissure
