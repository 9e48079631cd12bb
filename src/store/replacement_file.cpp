#include "store/replacement_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

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

std::filesystem::path ReplacementFile::temporaryName(const std::filesystem::path& target, int process,
                                                     int n) {
  std::filesystem::path name = target;
  for (const std::string& piece : {std::to_string(process), std::to_string(n), std::string("tmp")}) {
    name += ".";
    name += piece;
  }
  return name;
}

ReplacementFile::ReplacementFile(std::filesystem::path target) : target_(std::move(target)) {
  constexpr int most_names = 1000;
  for (int n = 0; !file_.valid(); ++n) {
    temporary_ = temporaryName(target_, ::getpid(), n);
    // A dead process of the same number may have left its file.
    if (std::filesystem::exists(temporary_) && n < most_names) continue;
    file_ = h5::OutputFile::create(temporary_, H5F_ACC_EXCL);
  }
}

ReplacementFile::~ReplacementFile() {
  file_.reset();
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void ReplacementFile::commit() {
  sync(temporary_, O_RDONLY);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) failSystem("cannot rename");
  temporary_.clear();
  sync(std::filesystem::absolute(target_).parent_path(), O_RDONLY | O_DIRECTORY);
}

}  // namespace fissure
