#include "study/tradeoff_output.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "files/write_file.h"
#include "study/study_command.h"
#include "table/sweep_csv.h"
#include "table/sweep_names.h"
#include "text/scalars.h"

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json jsonOf(const Spread& spread) {
  return {{"low", jsonOf(spread.low)},
          {"median", jsonOf(spread.median)},
          {"high", jsonOf(spread.high)},
          {"count", spread.count}};
}

/// The cost by its names in both files.
std::vector<std::pair<std::string, Spread>> namedCosts(const SettingCost& cost) {
  return {{"us_per_ms", cost.us_per_ms},
          {"p99_us_per_ms", cost.p99_us_per_ms},
          {"us_per_step", cost.us_per_step},
          {"p99_us_per_step", cost.p99_us_per_step},
          {"processor_s_per_s", cost.processor_s_per_s},
          {"memory_mib", cost.memory_mib}};
}

Json jsonOf(const JudgedSetting& setting, const TradeoffStudy& study, const TradeoffResult& result) {
  Json values = Json::object(), cost = Json::object(), errors = Json::object();
  for (std::size_t p = 0; p < result.paths.size(); ++p) values[result.paths[p]] = setting.values[p];
  for (const auto& [name, spread] : namedCosts(setting.cost)) cost[name] = jsonOf(spread);
  for (std::size_t e = 0; e < study.errors.size(); ++e) {
    const CurveError& of = setting.differences[e];
    errors[nameOf(study.errors[e].quantity)] = {{"rms", jsonOf(of.rms)},
                                                {"worst", jsonOf(of.worst)},
                                                {"peak", jsonOf(of.peak)},
                                                {"counts", jsonOf(setting.errors[e])}};
  }
  return {{"pipeline", setting.pipeline},
          {"values", values},
          {"status", nameOf(setting.status.end)},
          {"status_detail", setting.status.detail},
          {"cost", cost},
          {"errors", errors},
          {"weighed_error", jsonOf(setting.score)},
          {"front", setting.front}};
}

Json jsonOf(const JudgedReference& reference, const TradeoffStudy& study) {
  const StudyError& error = study.errors[reference.error];
  Json differences = Json::array();
  for (const double difference : reference.differences) differences.push_back(jsonOf(difference));
  return {{"pipeline", reference.pipeline},
          {"quantity", nameOf(error.quantity)},
          {"units", unitOf(error.quantity)},
          {"measure", std::string(errorMeasures()[static_cast<std::size_t>(error.measure)].name)},
          {"refused", reference.refinement.refused},
          {"order", jsonOf(reference.refinement.order)},
          {"own_error", jsonOf(reference.refinement.error)},
          {"tolerance", jsonOf(reference.tolerance)},
          {"peak", jsonOf(reference.peak)},
          {"peak_at_size_zero", jsonOf(reference.peak_limit)},
          {"differences_of_rungs", differences}};
}

Json jsonOf(const TradeoffAnswer& answer, const TradeoffStudy& study, const TradeoffResult& result) {
  const auto index = [](const std::optional<std::size_t>& of) { return of ? Json(*of) : Json(); };
  return {{"wish", answer.wish.text()},
          {"setting", index(answer.choice.best)},
          {"nearest", index(answer.choice.nearest)},
          {"times_beyond", jsonOf(answer.choice.times_over)},
          {"scenario", answer.file.filename().string()},
          {"again", answer.again ? jsonOf(*answer.again, study, result) : Json()},
          {"holds", answer.again ? Json(answer.holds) : Json()}};
}

std::string csvNumber(double value) {
  return std::isfinite(value) ? formatReal(value) : "";
}

}  // namespace

std::string tradeoffCsv(const TradeoffStudy& study, const TradeoffResult& result) {
  std::string text;
  const auto put = [&](const std::string& field) { text += csvField(field) + ","; };
  const auto endLine = [&] { text.back() = '\n'; };
  for (const std::string& name : sweepAxisNames(result.paths, {})) put(name);
  for (const char* name : {"pipeline", "status", "front", "weighed_error"}) put(name);
  for (const auto& [name, spread] : namedCosts({}))
    for (const char* part : {"", "_low", "_high"}) put(name + part);
  for (const StudyError& error : study.errors)
    for (const char* part : {"_rms_", "_worst_", "_peak_", "_reference_"})
      put(nameOf(error.quantity) + part + unitOf(error.quantity));
  endLine();
  for (const JudgedSetting& setting : result.settings) {
    for (const std::string& value : setting.values) put(value);
    for (const std::string& field : {setting.pipeline, nameOf(setting.status.end),
                                     std::string(setting.front ? "1" : "0"), csvNumber(setting.score)})
      put(field);
    for (const auto& [name, spread] : namedCosts(setting.cost))
      for (const double value : {spread.median, spread.low, spread.high}) put(csvNumber(value));
    for (std::size_t e = 0; e < study.errors.size(); ++e) {
      const CurveError& of = setting.differences[e];
      const JudgedReference* reference = result.referenceOf(setting.pipeline, e);
      for (const double value :
           {of.rms, of.worst, of.peak, reference ? reference->refinement.error : std::nan("")})
        put(csvNumber(value));
    }
    endLine();
  }
  return text;
}

std::string tradeoffJson(const TradeoffStudy& study, const TradeoffResult& result,
                         const std::vector<TradeoffAnswer>& answers, CostMeasure cost) {
  Json json = {{"format", "fissure-tradeoff"},
               {"format_version", 1},
               {"study", study.name},
               {"description", study.description},
               {"cost", cost == CostMeasure::mean ? "us_per_ms" : "p99_us_per_ms"},
               {"references", Json::array()},
               {"settings", Json::array()},
               {"orders", Json::array()},
               {"answers", Json::array()}};
  for (const JudgedReference& reference : result.references)
    json["references"].push_back(jsonOf(reference, study));
  for (const JudgedSetting& setting : result.settings) {
    json["settings"].push_back(jsonOf(setting, study, result));
    json["settings"].back()["command"] =
        runCommand(study.directory / study.base, setting.pipeline, overridesOf(setting, result));
  }
  for (const AxisOrder& order : result.orders)
    json["orders"].push_back({{"path", order.path},
                              {"pipeline", order.pipeline},
                              {"quantity", nameOf(study.errors[order.error].quantity)},
                              {"order", jsonOf(order.order)}});
  for (const TradeoffAnswer& answer : answers) json["answers"].push_back(jsonOf(answer, study, result));
  return json.dump(1) + "\n";
}

void writeTradeoff(const std::filesystem::path& folder, const TradeoffStudy& study,
                   const TradeoffResult& result, const std::vector<TradeoffAnswer>& answers,
                   CostMeasure cost) {
  replaceFile(folder / "tradeoff.csv", tradeoffCsv(study, result));
  replaceFile(folder / "tradeoff.json", tradeoffJson(study, result, answers, cost));
}

}  // namespace fissure
