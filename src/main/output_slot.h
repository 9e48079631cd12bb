#pragma once

#include <filesystem>
#include <optional>

#include "main/file_lock.h"

namespace fissure {

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

/// The place of one result file while its runs are made: claimed, and with a hidden folder beside it for the
/// parts. All but the result is gone afterwards. A front that is killed leaves folder and parts, for salvage;
/// the next slot of the same file removes them.
class OutputSlot {
 public:
  /// Throws InputError as OutputClaim does.
  OutputSlot(const std::filesystem::path& output, bool replace);
  ~OutputSlot();
  OutputSlot(const OutputSlot&) = delete;
  OutputSlot& operator=(const OutputSlot&) = delete;

  const std::filesystem::path& parts() const { return parts_; }
  /// Where an interrupted batch writes when the file already exists: `<output without .h5>.interrupted.h5`.
  std::filesystem::path interruptedOutput() const;

 private:
  void removeLeftovers() const;

  std::filesystem::path output_;
  OutputClaim claim_;
  std::filesystem::path parts_;
};

}  // namespace fissure
