#include "base/error.h"
#include "store/format.h"
#include "store/group_builder.h"
#include "store/result_file.h"

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
  result.status = {h5::textAttribute(group, "status"), h5::textAttribute(group, "status_detail")};
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

// Before anything else of the file is believed.
void checkFormat(hid_t file, ResultInfo& info) {
  info.format = h5::textAttribute(file, "format");
  if (info.format != result_format && info.format != part_format) {
    throw InputError(std::string("an HDF5 file, but no fissure result (expected attribute format = \"") +
                     result_format + "\")");
  }
  const long long version = h5::integerAttribute(file, "format_version", 0);
  if (version < 1 || version > format_version) {
    throw InputError("format_version " + std::to_string(version) + ", expected at most " +
                     std::to_string(format_version) + ": written by a newer fissure");
  }
  info.format_version = static_cast<int>(version);
}

ResultInfo readInfo(const h5::Id& file) {
  ResultInfo info;
  checkFormat(file, info);
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
  const std::string name = path.string();
  std::error_code reason;  // a loop of links, a name that is too long
  const std::filesystem::file_status status = std::filesystem::status(path, reason);
  if (status.type() == std::filesystem::file_type::not_found) throw InputError(name + ": no such file");
  if (reason) throw InputError(name + ": " + reason.message());
  if (!std::filesystem::is_regular_file(status))
    throw InputError(name + ": not a file, expected a fissure result");
  try {
    const h5::Id file = h5::openToRead(path);
    return readInfo(file);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  } catch (const RunError& error) {
    if (H5Fis_hdf5(path.c_str()) > 0) {
      throw InputError(name + ": a damaged or truncated HDF5 file (" + error.what() + ")");
    }
    throw InputError(name + ": not an HDF5 file, expected a fissure result (" + error.what() + ")");
  }
}

}  // namespace fissure
