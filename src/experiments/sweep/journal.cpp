#include "sweep/journal.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include "base/error.h"
#include "base/hash.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

// A record: 4 letters, its length, its checksum, both as 16 hexadecimal digits, and itself.
constexpr std::string_view mark = "FSR1";
constexpr std::size_t head_bytes = 4 + 16 + 16;
constexpr std::int64_t most_bytes = std::int64_t{1} << 40;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The record at the stream's place; nothing when it is torn or damaged, or at the end.
std::optional<std::string> readRecord(std::istream& stream) {
  std::string head(head_bytes, '\0');
  if (!stream.read(head.data(), static_cast<std::streamsize>(head.size())) || !head.starts_with(mark))
    return std::nullopt;
  const std::int64_t length = std::strtoll(head.substr(4, 16).c_str(), nullptr, 16);
  if (length < 0 || length > most_bytes) return std::nullopt;
  std::string record;
  while (static_cast<std::int64_t>(record.size()) < length) {  // a damaged length asks for no memory at once
    constexpr std::int64_t block = 1 << 24;
    const std::size_t before = record.size();
    record.resize(before +
                  static_cast<std::size_t>(std::min(block, length - static_cast<std::int64_t>(before))));
    if (!stream.read(record.data() + before, static_cast<std::streamsize>(record.size() - before)))
      return std::nullopt;
  }
  if (fnv1a64(record) != head.substr(20)) return std::nullopt;
  return record;
}

/// The identity of this machine since it was switched on: locks of other machines may not be seen here.
std::string bootId() {
  std::string id;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), id);
  return id;
}

std::string firstLineOf(const fs::path& file) {
  std::string line;
  std::ifstream stream(file);
  std::getline(stream, line);
  return line;
}

/// Whether the writer of a journal on this machine is gone: nobody holds its lock, or the file itself is
/// gone. Where the file system has no locks, nobody is.
bool isDead(const fs::path& journal) {
  const Descriptor file(::open(journal.c_str(), O_RDONLY | O_CLOEXEC));
  return file.open() ? ::flock(file.number(), LOCK_EX | LOCK_NB) == 0 : errno == ENOENT;
}

/// Whether this is why flock() fails on file systems that know no locks, where leftovers stay.
bool hasNoLocks(int reason) {
  return reason == ENOLCK || reason == ENOSYS || reason == EOPNOTSUPP || reason == EINVAL;
}

constexpr const char* owner_file = "machine";
constexpr std::string_view starting = ".starting";  // a journal without its name yet

/// A journal that another process is just about to lock may go too: that process makes a new one.
void removeLeftovers(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> works, unnamed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".work") works.push_back(entry.path());
    if (entry.path().extension() == starting) unnamed.push_back(entry.path());
  }
  for (const fs::path& journal : unnamed)
    if (isDead(journal)) fs::remove(journal, ignored);
  const std::string here = bootId();
  for (const fs::path& work : works) {
    const fs::path journal = fs::path(work).replace_extension(".journal");
    if (here.empty() || firstLineOf(work / owner_file) != here || !isDead(journal)) continue;
    if (fs::file_size(journal, ignored) == 0) fs::remove(journal, ignored);
    fs::remove_all(work, ignored);
  }
}

}  // namespace

JournalWriter::JournalWriter(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw RunError(fmt::format("{}: cannot be written: {}", folder.string(), error.message()));
  constexpr int attempts = 20;
  for (int attempt = 1; !makeIn(folder); ++attempt)
    if (attempt == attempts)
      throw RunError(folder.string() + ": cannot be written: journals vanish as they are made");
  std::ofstream(work_ / owner_file) << bootId() << "\n";  // without it nobody removes the folder
  removeLeftovers(folder);
}

/// Makes the journal and its folder of work. It gets its name once it is locked: others take a journal that
/// nobody holds for one whose writer is gone. False where one has done so before it was locked.
bool JournalWriter::makeIn(const fs::path& folder) {
  std::error_code error;
  std::string name = (folder / "XXXXXX").string().append(starting);
  file_ = Descriptor(::mkostemps(name.data(), static_cast<int>(starting.size()), O_APPEND | O_CLOEXEC));
  if (!file_.open())
    throw RunError(fmt::format("{}: cannot be written: {}", folder.string(), std::strerror(errno)));
  ::fchmod(file_.number(), 0644);
  const bool locked = ::flock(file_.number(), LOCK_EX) == 0 || hasNoLocks(errno);
  if (!locked) error = {errno, std::generic_category()};
  path_ = fs::path(name).replace_extension(".journal");
  work_ = fs::path(name).replace_extension(".work");
  if (!error) fs::rename(name, path_, error);
  if (error == std::errc::no_such_file_or_directory) return false;
  if (!error) fs::create_directory(work_, error);
  if (!error) return true;
  std::error_code ignored;
  for (const fs::path& made : {fs::path(name), path_}) fs::remove(made, ignored);
  throw RunError(path_.string() + ": cannot be made: " + error.message());
}

JournalWriter::~JournalWriter() {
  std::error_code ignored;
  fs::remove_all(work_, ignored);
  if (size_ == 0) fs::remove(path_, ignored);
}

void JournalWriter::append(const std::string& record) {
  std::string bytes(mark);
  bytes += fmt::format("{:016x}", record.size()) + fnv1a64(record) + record;
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(file_.number(), bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const std::string reason = std::strerror(errno);
      const int cut = ::ftruncate(file_.number(), size_);  // if that fails too, the checksum tells
      throw RunError(
          fmt::format("{}: cannot write: {}{}", path_.string(), reason, cut == 0 ? "" : ", its end is torn"));
    }
    done += static_cast<std::size_t>(count);
  }
  size_ += static_cast<std::int64_t>(bytes.size());
  struct stat found = {};
  if (::fstat(file_.number(), &found) == 0 && found.st_nlink == 0)
    throw RunError(path_.string() + ": somebody removed it while it was written");
}

void JournalWriter::sync(double every_s) {
  const double now = now_s();
  if (now - synced_s_ < every_s) return;
  synced_s_ = now;
  if (::fdatasync(file_.number()) != 0)
    throw RunError(path_.string() + ": cannot write: " + std::strerror(errno));
}

Journals::Journals(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".journal" && entry.is_regular_file(ignored))
      files_.push_back(entry.path());
  std::sort(files_.begin(), files_.end());
}

void Journals::each(const std::function<void(const std::string&, const JournalPlace&)>& take) {
  damaged_.clear();
  for (std::size_t i = 0; i < files_.size(); ++i) {
    std::ifstream stream(files_[i], std::ios::binary);
    if (!stream) {
      if (!fs::exists(files_[i])) continue;  // its writer had nothing to say, and is gone
      throw RunError(files_[i].string() + ": cannot be read");
    }
    std::int64_t offset = 0;
    while (const auto record = readRecord(stream)) {
      take(*record, {i, offset});
      offset += static_cast<std::int64_t>(head_bytes + record->size());
    }
    std::error_code ignored;
    const auto size = fs::file_size(files_[i], ignored);
    const bool rest = !ignored && static_cast<std::int64_t>(size) != offset;
    if (rest && isDead(files_[i])) damaged_.push_back(files_[i]);  // else its writer is at work
  }
}

std::string Journals::read(const JournalPlace& place, std::size_t first, std::size_t count) const {
  constexpr std::size_t most_open = 64;
  auto file = open_.find(place.journal);
  if (file == open_.end()) {
    if (open_.size() >= most_open) open_.clear();
    file = open_.emplace(place.journal, ::open(files_[place.journal].c_str(), O_RDONLY | O_CLOEXEC)).first;
  }
  std::string bytes(head_bytes, '\0');
  const auto readAt = [&](std::int64_t offset) {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t got = ::pread(file->second.number(), bytes.data() + done, bytes.size() - done,
                                  offset + static_cast<std::int64_t>(done));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) throw RunError(files_[place.journal].string() + ": a record in it is gone");
      done += static_cast<std::size_t>(got);
    }
  };
  readAt(place.offset);
  const std::size_t length = std::strtoull(bytes.substr(4, 16).c_str(), nullptr, 16);
  if (!bytes.starts_with(mark)) throw RunError(files_[place.journal].string() + ": a record in it is gone");
  first = std::min(first, length);
  bytes.assign(std::min(count, length - first), '\0');
  readAt(place.offset + static_cast<std::int64_t>(head_bytes + first));
  return bytes;
}

}  // namespace fissure
