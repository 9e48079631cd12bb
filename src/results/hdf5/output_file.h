#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "files/temporary_file.h"
#include "hdf5/h5.h"
#include "hdf5/write_driver.h"

namespace fissure::h5 {

enum class Space {
  dense,  ///< for files that get their name when they are whole
  paged  ///< no small structure crosses two pages: a writer killed between them leaves each whole; takes more
};

/// A file being written. That a disk was full shows in writeFailure(), checkWritten() and close(), not in the
/// results of HDF5's own functions.
class OutputFile {
 public:
  OutputFile() = default;
  /// Creates a file that must not exist yet (H5F_ACC_EXCL) or is replaced (H5F_ACC_TRUNC), in the 1.10 format
  /// with tracked creation order. HDF5's own error printing is off from here on. Throws RunError.
  static OutputFile create(const std::filesystem::path& path, unsigned flags, Space space = Space::dense);
  static OutputFile openToChange(const std::filesystem::path& path);
  OutputFile(OutputFile&&) noexcept = default;
  OutputFile& operator=(OutputFile&& other) noexcept;

  operator hid_t() const { return id_; }
  bool valid() const { return id_.valid(); }
  /// One line with the system's reason, when a write has failed since the file was opened.
  std::optional<std::string> writeFailure() const;
  /// Throws writeFailure() as RunError.
  void checkWritten() const;
  /// Both write everything out and throw RunError as checkWritten() does.
  void flush() const;
  void close();
  void reset() noexcept { id_.reset(); }

 private:
  void take(hid_t id, std::string_view doing);

  std::unique_ptr<DiskErrors> errors_ = std::make_unique<DiskErrors>();  ///< outlives id_
  Id id_;
};

}  // namespace fissure::h5

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
