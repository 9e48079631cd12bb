#pragma once

#include <filesystem>

#include "files/descriptor.h"

namespace fissure {

/// An exclusive lock that lives in a file of its own, which is gone when the lock is freed. The system frees
/// it when this process ends, however it ends; then an empty file stays, which stops nobody.
class FileLock {
 public:
  /// Makes and locks `path`. Throws InputError about `target`, what the lock guards: another process holds
  /// it, or its folder cannot be written.
  FileLock(const std::filesystem::path& path, const std::filesystem::path& target);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  Descriptor locked_;
};

}  // namespace fissure
