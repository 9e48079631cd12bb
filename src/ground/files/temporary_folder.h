#pragma once

#include <filesystem>

#include "files/descriptor.h"

namespace fissure {

/// A private folder in the system's folder for temporary files ($TMPDIR, else /tmp), removed with its
/// contents when this object is destroyed. A killed process leaves its folders behind; the next process that
/// makes a TemporaryFolder there removes them. A lock on each folder shows that it is in use: the system
/// releases it however its process ends.
class TemporaryFolder {
 public:
  /// Creates the folder. Throws RunError, with its name and the system's reason, when that fails.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor lock_;
};

}  // namespace fissure
