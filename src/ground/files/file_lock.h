#pragma once

#include <filesystem>

#include "files/descriptor.h"

namespace fissure {

/// An exclusive lock on a lock file, which is removed when the lock is released. When the process ends
/// without releasing it, the system does; an empty lock file then stays and blocks nobody.
class FileLock {
 public:
  /// Creates and locks the lock file `path`. Throws InputError about `target`, the file that the lock guards,
  /// when another process holds the lock or the folder cannot be written.
  FileLock(const std::filesystem::path& path, const std::filesystem::path& target);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  Descriptor locked_;
};

}  // namespace fissure
