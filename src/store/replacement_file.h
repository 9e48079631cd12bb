#pragma once

#include <filesystem>

#include "store/output_file.h"
#include "store/temporary_file.h"

namespace fissure {

/// An HDF5 file in the making that takes its place under its final name whole or not at all.
class ReplacementFile {
 public:
  /// Creates the temporary file. Throws RunError.
  explicit ReplacementFile(const std::filesystem::path& target);

  const h5::OutputFile& file() const { return file_; }
  const std::filesystem::path& temporaryPath() const { return temporary_.path(); }

  /// Writes everything out and closes the HDF5 file. Throws RunError, also when any earlier write had failed.
  void close() { file_.close(); }
  /// After close(): as TemporaryFile does.
  void commit() { temporary_.commit(); }

 private:
  TemporaryFile temporary_;
  h5::OutputFile file_;
};

}  // namespace fissure
