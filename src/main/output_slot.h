#pragma once

#include <filesystem>
#include <optional>

#include "main/file_lock.h"

namespace fissure {

/// The place of one result file while it is being made. Its existence means: the file can be written there,
/// no other run is writing it, and there is a hidden folder beside it for the parts. All but the result is
/// gone afterwards.
class OutputSlot {
 public:
  /// Makes the folder of `output`. Throws InputError when the file exists and `replace` is false, is no
  /// regular file, is being written by another run, or cannot be written.
  OutputSlot(const std::filesystem::path& output, bool replace);
  ~OutputSlot();
  OutputSlot(const OutputSlot&) = delete;
  OutputSlot& operator=(const OutputSlot&) = delete;

  const std::filesystem::path& output() const { return output_; }
  const std::filesystem::path& parts() const { return parts_; }

 private:
  void removeLeftovers() const;

  std::filesystem::path output_;
  std::optional<FileLock> lock_;
  std::filesystem::path parts_;
};

}  // namespace fissure
