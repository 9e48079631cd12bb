#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hdf5/h5.h"

namespace fissure {

/// What a file says it is: the formats that a reader takes, and how people call them.
struct StoredFormat {
  std::vector<std::string> names;
  std::string what;  ///< "a fissure result"
};

/// Opens `path` and gives it to `read` as an HDF5 file of one of the formats, not newer than format_version
/// (no names: of any). Throws InputError about the file when it is missing, no HDF5 file, of another format,
/// newer or damaged; a RunError of `read` counts as damage.
void readStoredFile(const std::filesystem::path& path, const StoredFormat& format,
                    const std::function<void(h5::Id file)>& read);

}  // namespace fissure
