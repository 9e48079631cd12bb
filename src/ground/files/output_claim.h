#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "files/file_lock.h"

namespace fissure {

/// Throws InputError when something stands at `output` that is no regular file, or that is one and `replace`
/// is false, and when its name leaves no room for those of files that are made beside it.
void refuseExisting(const std::filesystem::path& output, bool replace);

/// The right to write one result file: it can be written there, and nobody else is writing it.
class OutputClaim {
 public:
  /// Makes the folder of `output`. Throws InputError when the file exists and `replace` is false, is no
  /// regular file, is being written by another run, or cannot be written.
  OutputClaim(const std::filesystem::path& output, bool replace);

 private:
  std::optional<FileLock> lock_;
};

/// Throws InputError when `output` is the file that is read.
void refuseInput(const std::filesystem::path& input, const std::filesystem::path& output);

/// `.<name of output><ending>` in the folder of `output`.
std::filesystem::path hiddenBeside(const std::filesystem::path& output, const std::string& ending);

}  // namespace fissure
