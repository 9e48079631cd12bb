#include "store/stored_file.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "files/input_file.h"
#include "store/format.h"

namespace fissure {

namespace {

void checkFormat(hid_t file, const StoredFormat& format) {
  if (format.names.empty()) return;
  const std::string name = h5::textAttribute(file, "format");
  if (std::find(format.names.begin(), format.names.end(), name) == format.names.end()) {
    const std::string what = format.what.substr(format.what.find(' ') + 1);
    throw InputError(fmt::format("an HDF5 file, but no {} (expected attribute format = \"{}\")", what,
                                 format.names.front()));
  }
  const long long version = h5::integerAttribute(file, "format_version", 0);
  if (version < 1 || version > format_version) {
    throw InputError(fmt::format("format_version {}, expected at most {}: written by a newer fissure",
                                 version, format_version));
  }
}

}  // namespace

void readStoredFile(const std::filesystem::path& path, const StoredFormat& format,
                    const std::function<void(h5::Id file)>& read) {
  requireInputFile(path, format.what);
  try {
    h5::Id file = h5::openToRead(path);
    checkFormat(file, format);
    read(std::move(file));
  } catch (const InputError& error) {
    throw InputError(inFile(path), error.what());
  } catch (const RunError& error) {
    if (H5Fis_hdf5(path.c_str()) > 0) {
      throw InputError(inFile(path), std::string("a damaged or truncated HDF5 file (") + error.what() + ")");
    }
    throw InputError(inFile(path),
                     fmt::format("not an HDF5 file, expected {} ({})", format.what, error.what()));
  }
}

}  // namespace fissure
