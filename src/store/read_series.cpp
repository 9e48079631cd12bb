#include "store/read_series.h"

#include "base/error.h"
#include "store/h5.h"

namespace fissure {

namespace {

// Looks step by step: HDF5 calls a path with a missing group in its middle an error of its own.
bool datasetExists(hid_t file, const std::string& dataset) {
  for (std::size_t at = dataset.find('/', 1); at != std::string::npos; at = dataset.find('/', at + 1)) {
    if (!h5::exists(file, dataset.substr(0, at))) return false;
  }
  return h5::exists(file, dataset) && !h5::isGroup(h5::openObject(file, dataset));
}

template <typename Read>
auto readDataset(const std::filesystem::path& path, const std::string& name, bool text, Read read) {
  if (!std::filesystem::exists(path)) throw InputError(path.string() + ": no such file");
  try {
    const h5::Id file = h5::openToRead(path);
    if (name.empty() || !datasetExists(file, name)) throw RunError("no dataset " + name);
    const h5::Id dataset = h5::openDataset(file, name);
    if (h5::isText(dataset) != text) {
      throw RunError(name + " holds " + (text ? "numbers, expected text" : "text, expected numbers"));
    }
    return read(dataset);
  } catch (const RunError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace

SeriesData readSeries(const std::filesystem::path& file, const std::string& dataset) {
  return readDataset(file, dataset, false, [&](const h5::Id& id) {
    const std::vector<hsize_t> shape = h5::shapeOf(id);
    SeriesData data;
    data.shape.assign(shape.begin(), shape.end());
    std::size_t count = 1;
    for (const std::size_t length : data.shape) count *= length;
    data.values.resize(count);
    h5::check(H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.values.data()),
              "cannot read", dataset);
    return data;
  });
}

std::vector<std::string> readLabels(const std::filesystem::path& file, const std::string& dataset) {
  return readDataset(file, dataset, true, [](const h5::Id& id) { return h5::readTexts(id); });
}

}  // namespace fissure
