#pragma once

#include <filesystem>
#include <string>

namespace fissure {

/// The name of a file in the making that takes its place under its final name whole or not at all. It lies
/// beside that name; whoever drops it before commit() leaves nothing behind. The owner makes the file.
class TemporaryFile {
 public:
  /// `<target>.<process>.<n>.tmp`
  static std::filesystem::path nameFor(const std::filesystem::path& target, int process, int n);
  /// nameFor() this process with an n that nobody has.
  explicit TemporaryFile(std::filesystem::path target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Makes the file, of this text. Throws RunError("cannot write: <reason>").
  void write(const std::string& text) const;

  /// Of a finished and closed file: makes it durable, renames it to the target and makes the folder durable.
  /// Throws RunError.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
};

}  // namespace fissure
