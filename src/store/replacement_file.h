#pragma once

#include <filesystem>

#include "store/output_file.h"

namespace fissure {

/// An HDF5 file in the making that takes its place under its final name whole or not at all. It is written
/// beside that name; whoever drops it before commit() leaves nothing behind.
class ReplacementFile {
 public:
  /// `<target>.<process>.<n>.tmp`
  static std::filesystem::path temporaryName(const std::filesystem::path& target, int process, int n);
  /// Creates temporaryName() of this process with an n that nobody has. Throws RunError.
  explicit ReplacementFile(std::filesystem::path target);
  ~ReplacementFile();
  ReplacementFile(const ReplacementFile&) = delete;
  ReplacementFile& operator=(const ReplacementFile&) = delete;

  const h5::OutputFile& file() const { return file_; }
  const std::filesystem::path& temporaryPath() const { return temporary_; }

  /// Writes everything out and closes the HDF5 file. Throws RunError, also when any earlier write had failed.
  void close() { file_.close(); }
  /// After close(): makes the file durable, renames it to the target and makes the folder durable. Throws
  /// RunError.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  h5::OutputFile file_;
};

}  // namespace fissure
