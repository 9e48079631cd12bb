#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hdf5/h5.h"

namespace fissure {

/// The formats that a reader accepts, and their name for people.
struct StoredFormat {
  std::vector<std::string> names;
  /// Their name for people, as "a fissure result".
  std::string what;
};

/// Opens `path` and passes it to `read`, after checking that it is an HDF5 file of one of the formats (any,
/// if there are no names) and not newer than format_version. Throws InputError about the file when it is
/// missing, no HDF5 file, of another format, newer or damaged; a RunError thrown by `read` counts as damage.
void readStoredFile(const std::filesystem::path& path, const StoredFormat& format,
                    const std::function<void(h5::Id file)>& read);

}  // namespace fissure
