#include "hdf5/group_builder.h"
#include "store/format.h"
#include "store/result_file.h"
#include "store/stored_file.h"

namespace fissure {

namespace {

void listDatasets(hid_t group, const std::string& path, std::vector<DatasetInfo>& datasets) {
  for (const std::string& name : h5::childNames(group)) {
    const h5::Id child = h5::openObject(group, name);
    if (h5::isGroup(child)) {
      listDatasets(child, path + name + "/", datasets);
    } else if (!h5::isView(child)) {
      const std::vector<hsize_t> shape = h5::shapeOf(child);
      datasets.push_back({path + name,
                          h5::typeName(child),
                          {shape.begin(), shape.end()},
                          h5::textAttribute(child, "units")});
    }
  }
}

void addScalars(hid_t group, const std::string& prefix, Summary& summary) {
  for (const std::string& name : h5::attributeNames(group)) {
    if (const auto value = h5::attribute(group, name)) summary.push_back({prefix + name, *value});
  }
}

PipelineResult readPipeline(hid_t pipelines, const std::string& name) {
  const h5::Id group = h5::openGroup(pipelines, name);
  PipelineResult result;
  result.name = name;
  result.pipeline = h5::textAttribute(group, "pipeline");
  result.description = h5::textAttribute(group, "description");
  result.precision = h5::textAttribute(group, "precision");
  result.status = {runEndNamed(h5::textAttribute(group, "status")),
                   h5::textAttribute(group, "status_detail")};
  if (h5::exists(group, "summary")) addScalars(h5::openGroup(group, "summary"), "", result.summary);
  if (h5::exists(group, "timing")) addScalars(h5::openGroup(group, "timing"), "timing/", result.summary);
  return result;
}

void readProvenance(hid_t file, ResultInfo& info) {
  if (!h5::exists(file, "provenance")) return;
  const h5::Id group = h5::openGroup(file, "provenance");
  for (const std::string& name : h5::attributeNames(group)) {
    info.provenance.emplace_back(name, h5::textAttribute(group, name));
  }
  const std::vector<std::string> texts = h5::readTexts(h5::openDataset(group, "scenario_resolved"));
  if (!texts.empty()) info.scenario_resolved = texts.front();
}

ResultInfo readInfo(const h5::Id& file) {
  ResultInfo info;
  info.format = h5::textAttribute(file, "format");
  info.format_version = static_cast<int>(h5::integerAttribute(file, "format_version", 0));
  info.title = h5::textAttribute(file, "title");
  info.complete = h5::integerAttribute(file, "complete", 0) == 1;
  info.salvaged = h5::integerAttribute(file, "salvaged", 0) == 1;
  info.reference = h5::integerAttribute(file, "reference", 0) == 1;
  readProvenance(file, info);
  const h5::Id pipelines = h5::openGroup(file, "pipelines");
  for (const std::string& name : h5::childNames(pipelines))
    info.pipelines.push_back(readPipeline(pipelines, name));
  listDatasets(file, "/", info.datasets);
  return info;
}

}  // namespace

ResultInfo readResultInfo(const std::filesystem::path& path) {
  ResultInfo info;
  readStoredFile(path, {{result_format, part_format}, "a fissure result"},
                 [&](const h5::Id& file) { info = readInfo(file); });
  return info;
}

}  // namespace fissure
