#include "sweep/file_stamp.h"

#include <sys/stat.h>

#include <map>
#include <tuple>

#include "batch/provenance.h"

namespace fissure {

namespace {

long long nanoseconds(const timespec& time) {
  return time.tv_sec * 1000000000LL + time.tv_nsec;
}

/// Device, inode, size, and the times of the last change of its contents and of anything of it: whoever
/// writes the file and sets its time back changes the latter.
using Identity = std::tuple<dev_t, ino_t, off_t, long long, long long>;

Identity identityOf(const struct stat& found) {
  return {found.st_dev, found.st_ino, found.st_size, nanoseconds(found.st_mtim), nanoseconds(found.st_ctim)};
}

}  // namespace

FileStamp stampOf(const std::filesystem::path& file) {
  struct stat found = {};
  if (::stat(file.c_str(), &found) != 0) return {};
  return {found.st_size, nanoseconds(found.st_mtim)};
}

std::optional<std::string> knownHash(const std::filesystem::path& file) {
  static std::map<Identity, std::string> known;
  struct stat found = {};
  if (::stat(file.c_str(), &found) != 0) return std::nullopt;
  const auto before = known.find(identityOf(found));
  if (before != known.end()) return before->second;
  std::optional<std::string> hash = fileHash(file);
  if (hash) known.emplace(identityOf(found), *hash);
  return hash;
}

}  // namespace fissure
