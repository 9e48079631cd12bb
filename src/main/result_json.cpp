#include "main/result_json.h"

#include <nlohmann/json.hpp>

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;

Json pipelineJson(const PipelineResult& pipeline) {
  Json summary = Json::object();
  for (const SummaryValue& value : pipeline.summary)
    std::visit([&](const auto& known) { summary[value.name] = known; }, value.value);
  return {{"name", pipeline.name},
          {"pipeline", pipeline.pipeline},
          {"precision", pipeline.precision},
          {"description", pipeline.description},
          {"status", nameOf(pipeline.status.end)},
          {"status_detail", pipeline.status.detail},
          {"summary", summary}};
}

}  // namespace

Json resultJson(const std::filesystem::path& file, const ResultInfo& info) {
  Json provenance = Json::object();
  for (const auto& [name, value] : info.provenance) provenance[name] = value;
  Json pipelines = Json::array();
  for (const PipelineResult& pipeline : info.pipelines) pipelines.push_back(pipelineJson(pipeline));
  Json datasets = Json::array();
  for (const DatasetInfo& dataset : info.datasets)
    datasets.push_back(
        {{"path", dataset.path}, {"type", dataset.type}, {"shape", dataset.shape}, {"units", dataset.units}});
  return {{"file", file.string()},       {"title", info.title},
          {"format", info.format},       {"format_version", info.format_version},
          {"complete", info.complete},   {"salvaged", info.salvaged},
          {"reference", info.reference}, {"provenance", provenance},
          {"pipelines", pipelines},      {"datasets", datasets}};
}

std::string jsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fissure
