#include "files/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/error.h"
#include "files/write_file.h"

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

std::filesystem::path TemporaryFile::nameFor(const std::filesystem::path& target, int process, int n) {
  std::filesystem::path name = target;
  for (const std::string& piece : {std::to_string(process), std::to_string(n), std::string("tmp")}) {
    name += ".";
    name += piece;
  }
  return name;
}

TemporaryFile::TemporaryFile(std::filesystem::path target) : target_(std::move(target)) {
  constexpr int most_names = 1000;
  // A dead process of the same number may have left its file.
  for (int n = 0; n <= most_names; ++n) {
    path_ = nameFor(target_, ::getpid(), n);
    std::error_code ignored;
    if (!std::filesystem::exists(path_, ignored)) return;
  }
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove(path_, ignored);
}

void TemporaryFile::write(const std::string& text) const {
  if (!tryWritingFile(path_, text)) failSystem("cannot write");
}

void TemporaryFile::commit() {
  sync(path_, O_RDONLY);
  if (std::rename(path_.c_str(), target_.c_str()) != 0) failSystem("cannot rename");
  path_.clear();
  sync(std::filesystem::absolute(target_).parent_path(), O_RDONLY | O_DIRECTORY);
}

std::vector<std::filesystem::path> unfinishedOf(const std::filesystem::path& target) {
  const std::string beginning = target.filename().string() + ".", ending = ".tmp";
  const std::filesystem::path folder =
      target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
  std::vector<std::filesystem::path> found;
  std::error_code ignored;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(beginning) || !name.ends_with(ending)) continue;
    const bool numbered = name.find_first_not_of("0123456789.", beginning.size()) == name.size() - 3;
    if (numbered && std::filesystem::is_regular_file(entry.symlink_status(ignored)))
      found.push_back(entry.path());
  }
  return found;
}

void removeAbandoned(const std::filesystem::path& target) {
  std::error_code ignored;
  for (const std::filesystem::path& file : unfinishedOf(target)) {
    const std::size_t at = target.filename().string().size() + 1;
    const long process = std::strtol(file.filename().c_str() + at, nullptr, 10);
    if (process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH)
      std::filesystem::remove(file, ignored);
  }
}

}  // namespace fissure
