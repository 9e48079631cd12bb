#include "report/tradeoff_data.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/error.h"
#include "report/json_map.h"
#include "table/sweep_names.h"

namespace fissure {

namespace {

constexpr double same_error = 0.01;

/// Lists of what a setting has several of, in the order of the page.
struct TradeoffNames {
  std::vector<std::string> paths, quantities;
};

PageJson numbersOf(const JsonMap& map, const std::vector<const char*>& keys) {
  PageJson json = PageJson::object();
  for (const char* key : keys) json[key] = map.numberOrNull(key);
  return json;
}

/// Median and quartiles, null where there is no value.
PageJson spreadData(const JsonMap& map, const char* key) {
  const JsonMap spread(map.map(key));
  PageJson json = numbersOf(spread, {"low", "median", "high"});
  json["count"] = spread.count("count");
  return json;
}

PageJson referenceData(const PageJson& json) {
  const JsonMap reference(json);
  const std::string measure = reference.text("measure");
  const std::vector<std::string> known = {"rms", "worst", "peak"};
  if (std::find(known.begin(), known.end(), measure) == known.end())
    throw InputError(fmt::format("measure is \"{}\", expected rms, worst or peak", measure));
  PageJson data = {{"pipeline", reference.text("pipeline")},
                   {"quantity", reference.text("quantity")},
                   {"units", reference.text("units")},
                   {"measure", measure},
                   {"refused", reference.text("refused")}};
  data.update(numbersOf(reference, {"order", "own_error", "tolerance", "peak", "peak_at_size_zero"}));
  return data;
}

/// The index of the reference of a pipeline in a quantity: its own, or the only one; null where there is
/// none.
PageJson referenceOf(const PageJson& references, const std::string& pipeline, const std::string& quantity) {
  std::vector<std::size_t> found;
  for (std::size_t r = 0; r < references.size(); ++r) {
    if (references[r]["quantity"] != quantity) continue;
    if (references[r]["pipeline"] == pipeline) return r;
    found.push_back(r);
  }
  return found.size() == 1 ? PageJson(found[0]) : PageJson();
}

PageJson settingData(const PageJson& json, const TradeoffNames& names, const PageJson& references) {
  const JsonMap setting(json);
  const std::string pipeline = setting.text("pipeline");
  PageJson values = PageJson::array(), cost = PageJson::object(), errors = PageJson::array();
  const JsonMap at(setting.map("values"));
  for (const std::string& path : names.paths) values.push_back(at.text(path.c_str()));
  const JsonMap costs(setting.map("cost"));
  for (const char* key :
       {"us_per_ms", "p99_us_per_ms", "us_per_step", "p99_us_per_step", "processor_s_per_s", "memory_mib"})
    cost[key] = spreadData(costs, key);
  const JsonMap of(setting.map("errors"));
  for (const std::string& quantity : names.quantities) {
    errors.push_back(numbersOf(JsonMap(of.map(quantity.c_str())), {"rms", "worst", "peak", "counts"}));
    errors.back()["reference"] = referenceOf(references, pipeline, quantity);
  }
  return {{"pipeline", pipeline},
          {"values", values},
          {"status", setting.text("status")},
          {"detail", setting.text("status_detail")},
          {"cost", cost},
          {"errors", errors},
          {"weighed", setting.numberOrNull("weighed_error")},
          {"front", setting.truth("front")}};
}

/// The front of one quantity: an error counts as no smaller than that of its reference.
std::vector<std::size_t> frontIn(const PageJson& settings, std::size_t quantity, const std::string& cost,
                                 const PageJson& references) {
  std::vector<FrontPoint> points;
  std::vector<std::size_t> of;
  for (std::size_t s = 0; s < settings.size(); ++s) {
    const PageJson &median = settings[s]["cost"][cost]["median"], &error = settings[s]["errors"][quantity];
    if (median.is_null() || error["counts"].is_null() || error["reference"].is_null()) continue;
    const PageJson& own = references[error["reference"].get<std::size_t>()]["own_error"];
    points.push_back(
        {median, std::max(error["counts"].get<double>(), own.is_null() ? 0 : own.get<double>())});
    of.push_back(s);
  }
  std::vector<std::size_t> front;
  for (const std::size_t point : frontOf(points)) front.push_back(of[point]);
  return front;
}

PageJson quantitiesData(const TradeoffNames& names, const PageJson& references, const PageJson& settings,
                        const std::string& cost) {
  PageJson json = PageJson::array();
  for (std::size_t q = 0; q < names.quantities.size(); ++q) {
    PageJson own = PageJson::array();
    for (std::size_t r = 0; r < references.size(); ++r)
      if (references[r]["quantity"] == names.quantities[q]) own.push_back(r);
    const PageJson& first = references[own[0].get<std::size_t>()];
    json.push_back({{"name", names.quantities[q]},
                    {"units", first["units"]},
                    {"measure", first["measure"]},
                    {"references", own},
                    {"front", frontIn(settings, q, cost, references)}});
  }
  return json;
}

/// The index of a setting, or null.
PageJson settingIndex(const JsonMap& map, const char* key, std::size_t settings) {
  if (map.at(key, "a setting or null").is_null()) return nullptr;
  const std::size_t index = map.count(key, "a setting or null");
  if (index >= settings)
    throw InputError(
        fmt::format("\"{}\" is {}, expected the index of one of {} settings", key, index, settings));
  return index;
}

PageJson answerData(const PageJson& json, const TradeoffNames& names, const PageJson& references,
                    std::size_t settings) {
  const JsonMap answer(json);
  const bool again = !answer.at("again", "a setting or null").is_null();
  return {{"wish", answer.text("wish")},
          {"setting", settingIndex(answer, "setting", settings)},
          {"nearest", settingIndex(answer, "nearest", settings)},
          {"times_beyond", answer.numberOrNull("times_beyond")},
          {"scenario", answer.text("scenario")},
          {"again", again ? settingData(answer.map("again"), names, references) : PageJson()},
          {"holds", again ? PageJson(answer.truth("holds")) : PageJson()}};
}

}  // namespace

std::vector<std::size_t> frontOf(const std::vector<FrontPoint>& points) {
  std::vector<std::size_t> order(points.size()), front;
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(points[a].cost, points[a].error) < std::tie(points[b].cost, points[b].error);
  });
  std::optional<double> best;
  for (const std::size_t point : order) {
    if (best && points[point].error >= *best / (1 + same_error)) continue;
    best = points[point].error;
    front.push_back(point);
  }
  return front;
}

PageJson tradeoffData(const PageJson& study) {
  const JsonMap root(study);
  root.refuseOtherFormat("fissure-tradeoff");
  const std::string cost = root.text("cost");
  if (cost != "us_per_ms" && cost != "p99_us_per_ms")
    throw InputError(fmt::format("cost is \"{}\", expected us_per_ms or p99_us_per_ms", cost));
  TradeoffNames names;
  PageJson references = PageJson::array(), settings = PageJson::array(), orders = PageJson::array(),
           answers = PageJson::array();
  root.each("references", [&](const PageJson& reference) {
    references.push_back(referenceData(reference));
    const std::string quantity = references.back()["quantity"];
    if (std::find(names.quantities.begin(), names.quantities.end(), quantity) == names.quantities.end())
      names.quantities.push_back(quantity);
  });
  root.each("settings", [&](const PageJson& setting) {
    if (names.paths.empty())
      for (const auto& [path, value] : JsonMap(setting).map("values").items()) names.paths.push_back(path);
    settings.push_back(settingData(setting, names, references));
    settings.back()["command"] = JsonMap(setting).text("command");
  });
  root.each("orders", [&](const PageJson& json) {
    const JsonMap order(json);
    orders.push_back({{"path", order.text("path")},
                      {"pipeline", order.text("pipeline")},
                      {"quantity", order.text("quantity")},
                      {"order", spreadData(order, "order")}});
  });
  root.each("answers", [&](const PageJson& answer) {
    answers.push_back(answerData(answer, names, references, settings.size()));
  });
  return {{"name", root.text("study")},
          {"description", root.text("description")},
          {"cost", cost},
          {"paths", names.paths},
          {"names", sweepAxisNames(names.paths, {})},
          {"quantities", quantitiesData(names, references, settings, cost)},
          {"references", references},
          {"settings", settings},
          {"orders", orders},
          {"answers", answers}};
}

}  // namespace fissure
