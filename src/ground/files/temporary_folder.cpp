#include "files/temporary_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

const std::string name_begins = "fissure-scratch-";
constexpr std::size_t random_letters = 6;

[[noreturn]] void failSystem(const fs::path& folder) {
  throw RunError(folder.string() + ": cannot be made: " + std::strerror(errno));
}

/// An open folder that nobody else has locked, now locked; closed where somebody has, or where it is no
/// folder of this user's.
Descriptor lockUnused(const fs::path& folder) {
  Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct stat found = {};
  if (!opened.open() || ::fstat(opened.number(), &found) != 0 || found.st_uid != ::geteuid() ||
      ::flock(opened.number(), LOCK_EX | LOCK_NB) != 0)
    opened.reset();
  return opened;
}

/// What killed processes have left in `among`.
void removeLeftovers(const fs::path& among) {
  std::error_code ignored;
  std::vector<fs::path> candidates;
  for (const fs::directory_entry& entry : fs::directory_iterator(among, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(name_begins) && name.size() == name_begins.size() + random_letters)
      candidates.push_back(entry.path());
  }
  for (const fs::path& folder : candidates)
    if (const Descriptor locked = lockUnused(folder); locked.open()) fs::remove_all(folder, ignored);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code missing;
  const fs::path among = fs::temp_directory_path(missing);
  if (missing) throw RunError("no folder for temporary files: " + missing.message());
  removeLeftovers(among);
  // Between its making and its locking, another process may take it for a leftover.
  while (!lock_.open()) {
    std::string name = (among / (name_begins + std::string(random_letters, 'X'))).string();
    if (::mkdtemp(name.data()) == nullptr) failSystem(among / (name_begins + "..."));
    lock_ = lockUnused(name);
    std::error_code gone;
    if (lock_.open() && !fs::exists(name, gone)) lock_.reset();
    path_ = name;
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace fissure
