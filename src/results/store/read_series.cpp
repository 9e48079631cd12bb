#include "store/read_series.h"

#include "base/error.h"
#include "hdf5/h5.h"

namespace fissure {

namespace {

// Looks step by step: HDF5 calls a path with a missing group in its middle an error of its own.
bool datasetExists(hid_t file, const std::string& dataset) {
  for (std::size_t at = dataset.find('/', 1); at != std::string::npos; at = dataset.find('/', at + 1)) {
    if (!h5::exists(file, dataset.substr(0, at))) return false;
  }
  return h5::exists(file, dataset) && !h5::isGroup(h5::openObject(file, dataset));
}

SeriesData readNumbers(hid_t file, const std::string& name) {
  if (name.empty() || !datasetExists(file, name)) throw RunError("no dataset " + name);
  const h5::Id dataset = h5::openDataset(file, name);
  if (h5::isText(dataset)) throw RunError(name + " holds text, expected numbers");
  const std::vector<hsize_t> shape = h5::shapeOf(dataset);
  SeriesData data;
  data.shape.assign(shape.begin(), shape.end());
  std::size_t count = 1;
  for (const std::size_t length : data.shape) count *= length;
  h5::requireStored(dataset);
  data.values.resize(count);
  h5::check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.values.data()),
            "cannot read", name);
  return data;
}

}  // namespace

SeriesData readSeries(const std::filesystem::path& file, const std::string& dataset) {
  try {
    return readNumbers(h5::openToRead(file), dataset);
  } catch (const RunError& error) {
    throw InputError(inFile(file), error.what());
  }
}

}  // namespace fissure
