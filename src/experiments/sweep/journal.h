#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "files/descriptor.h"

namespace fissure {

/// What one process has finished of a sweep: a file of its own in `<sweep's folder>/journals`, to which
/// records are only appended. A writer that is killed leaves all records but perhaps the last one whole; that
/// one fails its checksum. While the writer lives it holds a lock on its file.
class JournalWriter {
 public:
  /// Makes the file, under a name that no other has, and removes what writers that are gone left: their work,
  /// and files with nothing in them. Throws RunError.
  explicit JournalWriter(const std::filesystem::path& folder);
  ~JournalWriter();  ///< removes work(), and the file when nothing is in it
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// Throws RunError with the system's reason; what came before stays whole then.
  void append(const std::string& record);
  /// Makes what was appended survive a loss of power; does nothing when that was done less than `every_s`
  /// ago.
  void sync(double every_s);

  const std::filesystem::path& path() const { return path_; }
  /// A folder of its own, `<journal without .journal>.work`, on the disk of the sweep: what is made there can
  /// be renamed to its place. What a killed writer leaves is removed by the next one on its machine.
  const std::filesystem::path& work() const { return work_; }

 private:
  std::filesystem::path path_;
  std::filesystem::path work_;
  Descriptor file_;
  std::int64_t size_ = 0;
  double synced_s_ = 0;
};

/// Where a record stands.
struct JournalPlace {
  std::size_t journal = 0;  ///< of Journals::files()
  std::int64_t offset = 0;
};

/// All journals of a sweep, read as they are at this moment.
class Journals {
 public:
  /// No folder is no journal. Throws RunError when one cannot be read.
  explicit Journals(const std::filesystem::path& folder);

  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// Every whole record, journal by journal. After one that is damaged or torn the rest of its journal is
  /// left out, because nobody knows where the next begins: see damaged().
  void each(const std::function<void(const std::string& record, const JournalPlace& place)>& take);
  /// Bytes `first` to `first + count - 1` of a record, fewer where it ends. Throws RunError when the journal
  /// is no longer there.
  std::string read(const JournalPlace& place, std::size_t first, std::size_t count) const;
  /// Journals with bytes after their last whole record, which their writer did not live to finish, or which
  /// somebody damaged; known after each().
  const std::vector<std::filesystem::path>& damaged() const { return damaged_; }

 private:
  std::vector<std::filesystem::path> files_;
  std::vector<std::filesystem::path> damaged_;
  mutable std::map<std::size_t, Descriptor> open_;  ///< some of the files
};

}  // namespace fissure
