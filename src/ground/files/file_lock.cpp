#include "files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "base/error.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// Whether `path` still names the open file: between opening and locking it, its last holder may have removed
/// it.
bool isNamed(const Descriptor& file, const fs::path& path) {
  struct stat ours = {};
  struct stat named = {};
  return ::fstat(file.number(), &ours) == 0 && ::stat(path.c_str(), &named) == 0 &&
         ours.st_ino == named.st_ino && ours.st_dev == named.st_dev;
}

}  // namespace

FileLock::FileLock(const fs::path& path, const fs::path& target) : path_(path) {
  constexpr int flags = O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW;
  do {
    locked_ = Descriptor(::open(path.c_str(), flags | O_EXCL, 0666));
    const bool made = locked_.open();
    if (!made && errno == EEXIST) locked_ = Descriptor(::open(path.c_str(), flags, 0666));
    if (!locked_.open())
      throw InputError(inFile(target), std::string("cannot be written: ") + std::strerror(errno));
    if (::flock(locked_.number(), LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK) throw InputError(inFile(target), "is being written by another run");
      const std::string reason = std::strerror(errno);
      std::error_code ignored;
      if (made) fs::remove(path, ignored);
      throw InputError(inFile(target), "cannot be locked: " + reason);
    }
  } while (!isNamed(locked_, path));
}

FileLock::~FileLock() {
  std::error_code ignored;
  fs::remove(path_, ignored);  // while it is still locked, so that nobody else holds what is removed
}

}  // namespace fissure
