#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "files/descriptor.h"

namespace fissure {

/// The journal of one process that works on a sweep: a file of its own in `<sweep's folder>/journals`, to
/// which records of finished tasks are only appended. A killed writer leaves all records intact except
/// perhaps the last, which then fails its checksum. The writer holds a lock on its file during its lifetime.
class JournalWriter {
 public:
  /// Creates the file under a unique name, and removes work folders and empty files that dead writers have
  /// left. Throws RunError when that fails.
  explicit JournalWriter(const std::filesystem::path& folder);
  ~JournalWriter();  ///< removes work(), and the file if it is empty
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// Appends a record. Throws RunError with the system's reason; earlier records then stay intact.
  void append(const std::string& record);
  /// Flushes appended records to disk, so that they survive a loss of power, unless that was done less than
  /// `every_s` seconds ago.
  void sync(double every_s);

  const std::filesystem::path& path() const { return path_; }
  /// A folder of the writer's own, `<journal without .journal>.work`, on the disk of the sweep, from which
  /// files can be renamed to their places. The next writer on the same machine removes that of a killed
  /// writer.
  const std::filesystem::path& work() const { return work_; }

 private:
  bool makeIn(const std::filesystem::path& folder);

  std::filesystem::path path_;
  std::filesystem::path work_;
  Descriptor file_;
  std::int64_t size_ = 0;
  double synced_s_ = 0;
};

/// The place of a record.
struct JournalPlace {
  std::size_t journal = 0;  ///< index in Journals::files()
  std::int64_t offset = 0;
};

/// All journals of a sweep in their present state.
class Journals {
 public:
  /// A missing folder counts as empty. Throws RunError when a journal cannot be read.
  explicit Journals(const std::filesystem::path& folder);

  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// Calls `take` with every intact record, journal by journal. After a damaged or incomplete record the rest
  /// of its journal is skipped, because the beginning of the next is unknown: see damaged().
  void each(const std::function<void(const std::string& record, const JournalPlace& place)>& take);
  /// Bytes `first` to `first + count - 1` of a record, fewer where it ends before. Throws RunError when the
  /// journal does not exist any more.
  std::string read(const JournalPlace& place, std::size_t first, std::size_t count) const;
  /// Journals with further bytes after their last intact record, unfinished or damaged; known after each().
  const std::vector<std::filesystem::path>& damaged() const { return damaged_; }

 private:
  std::vector<std::filesystem::path> files_;
  std::vector<std::filesystem::path> damaged_;
  mutable std::map<std::size_t, Descriptor> open_;  ///< those of the files that are open
};

}  // namespace fissure
