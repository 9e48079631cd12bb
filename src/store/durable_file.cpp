#include "store/durable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/error.h"

namespace fissure {

namespace {

[[noreturn]] void failSystem(const std::string& doing) {
  const int reason = errno;
  throw RunError(doing + ": " + std::strerror(reason));
}

void sync(const std::filesystem::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) failSystem("cannot sync");
  const int synced = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  // EINVAL: the file system has nothing to sync for a folder.
  if (synced != 0 && reason != EINVAL) failSystem("cannot sync");
}

}  // namespace

std::filesystem::path temporaryName(const std::filesystem::path& target, int process, int n) {
  std::filesystem::path name = target;
  for (const std::string& piece : {std::to_string(process), std::to_string(n), std::string("tmp")}) {
    name += ".";
    name += piece;
  }
  return name;
}

void moveIntoPlace(const std::filesystem::path& written, const std::filesystem::path& target) {
  sync(written, O_RDONLY);
  if (std::rename(written.c_str(), target.c_str()) != 0) failSystem("cannot rename");
  sync(std::filesystem::absolute(target).parent_path(), O_RDONLY | O_DIRECTORY);
}

}  // namespace fissure
