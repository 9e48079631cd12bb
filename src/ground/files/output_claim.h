#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "files/file_lock.h"

namespace fissure {

/// Throws InputError when `output` exists and is no regular file, when it exists and `replace` is false, and
/// when its name is too long for the temporary files beside it, whose names extend it.
void refuseExisting(const std::filesystem::path& output, bool replace);

/// The right to write one result file, as long as this object lives: the file can be written, and no other
/// process is writing it.
class OutputClaim {
 public:
  /// Creates the folder of `output` where it is missing, and removes what killed processes have left of it
  /// (TemporaryFile). Throws InputError as refuseExisting does, and when the file is being written by another
  /// run or cannot be written.
  OutputClaim(const std::filesystem::path& output, bool replace);

 private:
  std::optional<FileLock> lock_;
};

/// Throws InputError when `output` is the same file as `input`.
void refuseInput(const std::filesystem::path& input, const std::filesystem::path& output);

/// The path `.<name of output><ending>` in the folder of `output`.
std::filesystem::path hiddenBeside(const std::filesystem::path& output, const std::string& ending);

}  // namespace fissure
