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
  dense,  ///< for files that get their final name when they are complete
  paged   ///< larger, but no small structure crosses a page, so that a killed writer leaves each intact
};

/// An HDF5 file that is being written. Failed writes (a full disk) are reported by writeFailure(),
/// checkWritten() and close(), not by HDF5's own functions (useWriteDriver).
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
  /// One line with the system's reason, if a write has failed since the file was opened; else no value.
  std::optional<std::string> writeFailure() const;
  /// Throws writeFailure() as RunError.
  void checkWritten() const;
  /// Both write all buffered data and throw RunError as checkWritten() does.
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

/// An unfinished HDF5 file that appears under its final name complete or not at all (see TemporaryFile).
class ReplacementFile {
 public:
  /// Creates the temporary file. Throws RunError.
  explicit ReplacementFile(const std::filesystem::path& target);

  const h5::OutputFile& file() const { return file_; }
  const std::filesystem::path& temporaryPath() const { return temporary_.path(); }

  /// Writes all data and closes the HDF5 file. Throws RunError when this or any earlier write failed.
  void close() { file_.close(); }
  /// To be called after close(): as TemporaryFile::commit().
  void commit() { temporary_.commit(); }

 private:
  TemporaryFile temporary_;
  h5::OutputFile file_;
};

}  // namespace fissure
