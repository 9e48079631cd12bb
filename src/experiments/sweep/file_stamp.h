#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace fissure {

/// What tells that a file is still the one that was seen before.
struct FileStamp {
  long long bytes = -1;  ///< -1: there is no such file
  long long time = 0;    ///< of its last change, in nanoseconds since 1970

  bool operator==(const FileStamp&) const = default;
};

FileStamp stampOf(const std::filesystem::path& file);

/// The hash of a file's contents as fileHash gives it; no value when it cannot be read. Within one process a
/// file is read again only when it was written since: plans of sweeps ask for the same large programs again
/// and again. For the main thread alone.
std::optional<std::string> knownHash(const std::filesystem::path& file);

}  // namespace fissure
