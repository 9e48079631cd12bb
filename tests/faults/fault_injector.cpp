// A library to be preloaded: lets a chosen call that changes files fail, and sets the calendar clock forward
// or back. All processes that map the control file of $FISSURE_FAULTS count together. scripts/fault_calls.py
// writes that file. Only files below one folder count, so that what a system library does elsewhere does not.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

namespace {

constexpr std::uint64_t kOpen = 1, kWrite = 2, kTruncate = 4, kSync = 8, kClose = 16, kRename = 32,
                        kRemove = 64, kFolder = 128, kLink = 256, kLock = 512;

/// The control file, as scripts/fault_calls.py lays it out.
struct Control {
  std::atomic<std::uint64_t> calls;   ///< of the kinds that count, until now
  std::atomic<std::uint64_t> failed;  ///< of them
  std::uint64_t first;                ///< the call that fails, from 1; 0: none
  std::uint64_t kinds;                ///< bits: which calls count
  std::uint64_t again;                ///< bits: which calls fail after the first, too
  std::int64_t error;                 ///< errno of what fails
  std::uint64_t shorten;              ///< not 0: a write that is to fail first writes one half and succeeds
  std::atomic<std::uint64_t> clock_reads;  ///< of CLOCK_REALTIME, until now
  std::uint64_t clock_from;                ///< the reading from which on it is shifted, from 1; 0: none
  std::int64_t clock_shift_s;              ///< by so much
  std::array<char, PATH_MAX> folder;       ///< calls on what is in it count
  std::array<char, PATH_MAX> among;        ///< calls count on paths with this text; empty: on all
  std::array<char, PATH_MAX> what;         ///< the first call that failed: its name and its file
};

Control* control = nullptr;

__attribute__((constructor)) void mapControl() {
  const char* name = std::getenv("FISSURE_FAULTS");
  if (!name) return;
  const auto real_open = reinterpret_cast<int (*)(const char*, int, ...)>(::dlsym(RTLD_NEXT, "open"));
  const auto real_close = reinterpret_cast<int (*)(int)>(::dlsym(RTLD_NEXT, "close"));
  const int file = real_open(name, O_RDWR | O_CLOEXEC);
  if (file < 0) return;
  void* mapped = ::mmap(nullptr, sizeof(Control), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  real_close(file);
  if (mapped != MAP_FAILED) control = static_cast<Control*>(mapped);
}

/// The function that this library stands in front of.
template <typename Function>
Function* next(Function*, const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}
#define NEXT(function)                                     \
  ([] {                                                    \
    static const auto real = next(&(function), #function); \
    return real;                                           \
  }())

bool isBelowFolder(const std::string& path) {
  const std::string folder = control->folder.data();
  return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

std::string fileOf(int descriptor) {
  std::array<char, PATH_MAX> target{};
  const std::string name = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = ::readlink(name.c_str(), target.data(), target.size() - 1);
  return length > 0 ? std::string(target.data(), static_cast<std::size_t>(length)) : std::string();
}

/// An absolute path of a file that need not exist, its folder without links; empty where the folder does not
/// exist.
std::string absolute(int folder, const char* path) {
  std::string name = path;
  if (name.empty()) return "";
  if (name.front() != '/') name.insert(0, (folder == AT_FDCWD ? "." : fileOf(folder)) + "/");
  const std::size_t slash =
      name.find_last_not_of('/') == std::string::npos ? 0 : name.rfind('/', name.find_last_not_of('/'));
  std::array<char, PATH_MAX> parent{};
  if (!::realpath(name.substr(0, slash + 1).c_str(), parent.data())) return "";
  return std::string(parent.data()) + name.substr(slash);
}

enum class Fate { proceed, fail, halve };

/// What becomes of this call; counts it.
Fate fateOf(std::uint64_t kind, const char* call, const std::string& file) {
  if ((control->kinds & kind) == 0 || !isBelowFolder(file)) return Fate::proceed;
  if (file.find(control->among.data()) == std::string::npos) return Fate::proceed;
  const std::uint64_t number = ++control->calls;
  if (control->first == 0 || number < control->first) return Fate::proceed;
  if (number > control->first && (control->again & kind) == 0) return Fate::proceed;
  if (++control->failed == 1)
    std::snprintf(control->what.data(), control->what.size(), "%s %s", call, file.c_str());
  return number == control->first && control->shorten != 0 && kind == kWrite ? Fate::halve : Fate::fail;
}

/// Keeps errno as the program knows it, unless the call is to fail.
template <typename File>
Fate decide(std::uint64_t kind, const char* call, const File& file) {
  if (!control) return Fate::proceed;
  const int before = errno;
  const Fate fate = fateOf(kind, call, file());
  errno = fate == Fate::fail ? static_cast<int>(control->error) : before;
  return fate;
}

bool failsAt(std::uint64_t kind, const char* call, const char* path, int folder = AT_FDCWD) {
  return decide(kind, call, [&] { return absolute(folder, path); }) == Fate::fail;
}
bool failsFor(std::uint64_t kind, const char* call, int descriptor) {
  return decide(kind, call, [&] { return fileOf(descriptor); }) == Fate::fail;
}

bool changes(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC)) != 0;
}

mode_t modeOf(int flags, va_list& arguments) {
  return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

std::size_t written(Fate fate, std::size_t size) {
  return fate == Fate::halve ? (size + 1) / 2 : size;
}

std::int64_t shift_s(clockid_t clock) {
  if (!control || clock != CLOCK_REALTIME) return 0;
  const std::uint64_t number = ++control->clock_reads;
  return control->clock_from != 0 && number >= control->clock_from ? control->clock_shift_s : 0;
}

/// A stream whose writing and closing pass through write() and close() below: those of the C library do not.
struct Stream {
  int descriptor;
};

ssize_t writeStream(void* stream, const char* bytes, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::write(static_cast<Stream*>(stream)->descriptor, bytes + done, size - done);
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  return static_cast<ssize_t>(done);
}

int closeStream(void* stream) {
  const int closed = ::close(static_cast<Stream*>(stream)->descriptor);
  delete static_cast<Stream*>(stream);
  return closed;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = modeOf(flags, arguments);
  va_end(arguments);
  if (changes(flags) && failsAt(kOpen, "open", path)) return -1;
  return NEXT(open)(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = modeOf(flags, arguments);
  va_end(arguments);
  if (changes(flags) && failsAt(kOpen, "open", path, folder)) return -1;
  return NEXT(openat)(folder, path, flags, mode);
}

// What libstdc++ opens, to write by itself.
FILE* fopen64(const char* path, const char* mode) {
  const bool reads = mode[0] == 'r' && !std::strchr(mode, '+');
  if (!reads && failsAt(kOpen, "open", path)) return nullptr;
  return NEXT(fopen64)(path, mode);
}

FILE* fopen(const char* path, const char* mode) {
  if (!control || mode[0] == 'r' || std::strchr(mode, '+')) return NEXT(fopen)(path, mode);
  int flags = O_WRONLY | O_CREAT | (mode[0] == 'a' ? O_APPEND : O_TRUNC);
  if (std::strchr(mode, 'x')) flags |= O_EXCL;
  if (std::strchr(mode, 'e')) flags |= O_CLOEXEC;
  const int descriptor = ::open(path, flags, 0666);
  if (descriptor < 0) return nullptr;
  return ::fopencookie(new Stream{descriptor}, "w", {nullptr, writeStream, nullptr, closeStream});
}

int mkostemps(char* name, int ending, int flags) {
  if (failsAt(kOpen, "open", name)) return -1;
  return NEXT(mkostemps)(name, ending, flags);
}

char* mkdtemp(char* name) {
  if (failsAt(kFolder, "mkdir", name)) return nullptr;
  return NEXT(mkdtemp)(name);
}

int mkdir(const char* path, mode_t mode) {
  if (failsAt(kFolder, "mkdir", path)) return -1;
  return NEXT(mkdir)(path, mode);
}

ssize_t write(int file, const void* bytes, std::size_t size) {
  const Fate fate = decide(kWrite, "write", [&] { return fileOf(file); });
  if (fate == Fate::fail) return -1;
  return NEXT(write)(file, bytes, written(fate, size));
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t at) {
  const Fate fate = decide(kWrite, "write", [&] { return fileOf(file); });
  if (fate == Fate::fail) return -1;
  return NEXT(pwrite)(file, bytes, written(fate, size), at);
}

ssize_t writev(int file, const iovec* pieces, int count) {
  const Fate fate = decide(kWrite, "write", [&] { return fileOf(file); });
  if (fate == Fate::fail) return -1;
  if (fate == Fate::halve) return NEXT(write)(file, pieces[0].iov_base, (pieces[0].iov_len + 1) / 2);
  return NEXT(writev)(file, pieces, count);
}

int ftruncate(int file, off_t size) {
  return failsFor(kTruncate, "truncate", file) ? -1 : NEXT(ftruncate)(file, size);
}

int fsync(int file) {
  return failsFor(kSync, "sync", file) ? -1 : NEXT(fsync)(file);
}

int fdatasync(int file) {
  return failsFor(kSync, "sync", file) ? -1 : NEXT(fdatasync)(file);
}

// As on Linux: what could not be closed is closed. That of a file that was only read changes nothing.
int close(int file) {
  const int flags = control ? ::fcntl(file, F_GETFL) : -1;
  const bool fails = flags >= 0 && changes(flags) && failsFor(kClose, "close", file);
  const int reason = errno;
  const int closed = NEXT(close)(file);
  if (!fails) return closed;
  errno = reason;
  return -1;
}

int rename(const char* from, const char* to) {
  return failsAt(kRename, "rename", to) ? -1 : NEXT(rename)(from, to);
}

int link(const char* from, const char* to) {
  return failsAt(kLink, "link", to) ? -1 : NEXT(link)(from, to);
}

int symlink(const char* from, const char* to) {
  return failsAt(kLink, "link", to) ? -1 : NEXT(symlink)(from, to);
}

int remove(const char* path) {
  return failsAt(kRemove, "remove", path) ? -1 : NEXT(remove)(path);
}

int unlink(const char* path) {
  return failsAt(kRemove, "remove", path) ? -1 : NEXT(unlink)(path);
}

int rmdir(const char* path) {
  return failsAt(kRemove, "remove", path) ? -1 : NEXT(rmdir)(path);
}

int unlinkat(int folder, const char* path, int flags) {
  return failsAt(kRemove, "remove", path, folder) ? -1 : NEXT(unlinkat)(folder, path, flags);
}

int flock(int file, int operation) {
  return failsFor(kLock, "lock", file) ? -1 : NEXT(flock)(file, operation);
}

int clock_gettime(clockid_t clock, timespec* found) {
  const int got = NEXT(clock_gettime)(clock, found);
  found->tv_sec += shift_s(clock);
  return got;
}

time_t time(time_t* found) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  if (found) *found = now.tv_sec;
  return now.tv_sec;
}

int gettimeofday(timeval* found, void*) {
  timespec now{};
  const int got = ::clock_gettime(CLOCK_REALTIME, &now);
  *found = {now.tv_sec, now.tv_nsec / 1000};
  return got;
}

}  // extern "C"
