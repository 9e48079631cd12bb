#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fissure {

/// The name of an unfinished file, which commit() renames to its final name: there the file appears complete
/// or not at all. It lies beside the final name and is removed when this object is destroyed without
/// commit(). The caller creates the file.
class TemporaryFile {
 public:
  /// `<target>.<process>.<n>.tmp`
  static std::filesystem::path nameFor(const std::filesystem::path& target, int process, int n);
  /// Takes nameFor() this process with an unused n.
  explicit TemporaryFile(std::filesystem::path target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Creates the file with this text. Throws RunError("cannot write: <reason>").
  void write(const std::string& text) const;

  /// Flushes the file, which must be complete and closed, to disk, renames it to the target and flushes the
  /// folder. Throws RunError when one of these fails.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
};

/// Files beside `target` that have the names of its TemporaryFile in whatever process. Where nobody writes it
/// (OutputClaim), killed processes have left them.
std::vector<std::filesystem::path> unfinishedOf(const std::filesystem::path& target);

/// Removes those of them whose process lives no more on this machine, as far as that can be done. One that
/// lives on another machine under the number of a dead one here loses its file, and its commit() fails.
void removeAbandoned(const std::filesystem::path& target);

}  // namespace fissure
