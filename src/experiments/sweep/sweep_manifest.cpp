#include "sweep/sweep_manifest.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "sweep/sweep_planning.h"
#include "text/text_file.h"

namespace fissure {

namespace {

using nlohmann::ordered_json;

constexpr const char* format_name = "fissure-sweep-plan";
constexpr int format_version = 1;

template <class T>
ordered_json orNull(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

template <class T>
void take(const ordered_json& json, const char* key, std::optional<T>& value) {
  if (!json.at(key).is_null()) value = json.at(key).get<T>();
}

/// A whole number from `least` to `most`.
int integerIn(const ordered_json& json, const char* key, int least, int most) {
  const ordered_json& value = json.at(key);
  if (!value.is_number_integer() || value < least || value > most)
    throw std::out_of_range(fmt::format("{} is not from {} to {}", key, least, most));
  return value.get<int>();
}

/// The enumerator of a choice that `table` lists.
template <class Enum>
Enum choiceIn(const ordered_json& json, const char* key, const std::vector<CatalogEntry>& table) {
  return static_cast<Enum>(integerIn(json, key, 0, static_cast<int>(table.size()) - 1));
}

void readSettings(const ordered_json& json, SweepSettings& settings) {
  settings.name = json.at("name");
  settings.description = json.at("description");
  settings.source = json.at("sweep_source");
  settings.design = choiceIn<SweepDesign>(json, "design", sweepDesigns());
  settings.keep = choiceIn<SweepKeep>(json, "keep", sweepKeeps());
  settings.repeats = integerIn(json, "repeats", 1, static_cast<int>(max_sweep_runs));
  take(json.at("limits"), "time_s", settings.limits.time_s);
  take(json.at("limits"), "memory_mb", settings.limits.memory_mib);
  if (const ordered_json& fit = json.at("fit"); !fit.is_null()) {
    settings.fit.emplace();
    settings.fit->curve = fit.at("curve");
    take(fit, "columns", settings.fit->columns);
    settings.fit->match = fit.at("match") == "time" ? MatchBy::time : MatchBy::depth;
    take(fit, "law", settings.fit->law);
    settings.fit->free_offset = fit.at("free_offset");
  }
  const ordered_json& curves = json.at("curves");
  if (curves.is_null()) return;
  settings.curves.emplace();
  settings.curves->quantities = curves.at("quantities").get<std::vector<std::string>>();
  settings.curves->every_s = curves.at("every_s");
  take(curves, "until_s", settings.curves->until_s);
}

SweepPoints readPoints(const ordered_json& json) {
  auto paths = json.at("paths").get<std::vector<std::string>>();
  auto texts = json.at("texts").get<std::vector<std::string>>();
  std::vector<std::size_t> points;
  for (const ordered_json& text : json.at("points")) {
    if (!text.is_number_unsigned()) throw std::out_of_range("a point is no list of values");
    points.push_back(text.get<std::size_t>());
  }
  if (paths.empty() || points.empty() || points.size() % paths.size() != 0)
    throw std::out_of_range("points do not fit the axes");
  for (const std::size_t text : points)
    if (text >= texts.size()) throw std::out_of_range("a point has no value");
  return {std::move(paths), std::move(texts), std::move(points)};
}

SweepManifest fromJson(const ordered_json& json) {
  SweepManifest manifest;
  readSettings(json, manifest.settings);
  manifest.scenario = json.at("scenario");
  manifest.directory = json.at("directory");
  manifest.inputs = json.at("inputs").get<std::map<std::string, std::string>>();
  manifest.axis_inputs = json.at("axis_inputs").get<std::set<std::string>>();
  manifest.engines = json.at("engines").get<std::map<std::string, std::string>>();
  manifest.pipelines = json.at("pipelines").get<std::vector<std::string>>();
  for (const ordered_json& curve : json.at("curve_quantities"))
    manifest.curves.push_back(
        {curve.at("name"), curve.at("units"), curve.at("long_name"), curve.at("per_law")});
  manifest.measured = json.at("measured");
  manifest.points = readPoints(json);
  if (manifest.pipelines.empty()) throw std::out_of_range("no run is in it");
  const auto runs = static_cast<double>(manifest.points.size() * manifest.pipelines.size());
  if (runs * manifest.settings.repeats > max_sweep_runs)
    throw std::out_of_range("more runs than a sweep can have");
  for (const std::string& file : manifest.axis_inputs)
    if (!manifest.inputs.contains(file)) throw std::out_of_range("a file of an axis is not among the inputs");
  return manifest;
}

}  // namespace

std::filesystem::path manifestFile(const std::filesystem::path& folder) {
  return folder / "manifest.json";
}

std::string manifestText(const SweepManifest& manifest) {
  const SweepSettings& settings = manifest.settings;
  ordered_json curves;
  if (settings.curves)
    curves = {{"quantities", settings.curves->quantities},
              {"every_s", settings.curves->every_s},
              {"until_s", orNull(settings.curves->until_s)}};
  ordered_json fit;
  if (settings.fit)
    fit = {{"curve", settings.fit->curve},
           {"columns", orNull(settings.fit->columns)},
           {"match", settings.fit->match == MatchBy::time ? "time" : "depth"},
           {"law", orNull(settings.fit->law)},
           {"free_offset", settings.fit->free_offset}};
  ordered_json quantities = ordered_json::array();
  for (const CurveQuantity& curve : manifest.curves)
    quantities.push_back({{"name", curve.name},
                          {"units", curve.units},
                          {"long_name", curve.long_name},
                          {"per_law", curve.per_law}});
  const ordered_json json = {
      {"format", format_name},
      {"format_version", format_version},
      {"name", settings.name},
      {"description", settings.description},
      {"pipelines", manifest.pipelines},
      {"repeats", settings.repeats},
      {"design", static_cast<int>(settings.design)},
      {"keep", static_cast<int>(settings.keep)},
      {"curves", curves},
      {"curve_quantities", quantities},
      {"fit", fit},
      {"measured", manifest.measured},
      {"limits",
       {{"time_s", orNull(settings.limits.time_s)}, {"memory_mb", orNull(settings.limits.memory_mib)}}},
      {"directory", manifest.directory},
      {"inputs", manifest.inputs},
      {"axis_inputs", manifest.axis_inputs},
      {"engines", manifest.engines},
      {"sweep_source", settings.source},
      {"scenario", manifest.scenario},
      {"paths", manifest.points.paths()},
      {"texts", manifest.points.texts()},
      {"points", manifest.points.indices()},
  };
  return json.dump() + "\n";
}

SweepManifest readManifest(const std::filesystem::path& folder) {
  const std::filesystem::path file = manifestFile(folder);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError(inFile(folder), "holds no sweep (manifest.json is missing), expected its folder");
  try {
    const ordered_json json = ordered_json::parse(readTextFile(file));
    if (json.at("format") != format_name) throw std::out_of_range("another format");
    if (json.at("format_version") > format_version)
      throw InputError(inFile(file), "of a newer fissure, expected format_version 1");
    return fromJson(json);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {  // of the parser: syntax, types, what is missing
    throw DamagedManifest(inFile(file),
                          fmt::format("damaged ({}), expected the plan of a sweep", error.what()));
  }
}

}  // namespace fissure
