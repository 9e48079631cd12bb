#include "files/input_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "files/descriptor.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

class InputFile {
 public:
  InputFile(const fs::path& file, const std::string& expected) : file_(file), expected_(expected) {
    // The kind before the opening: opening a device may do something already.
    struct stat found = {};
    if (::stat(file.c_str(), &found) != 0) failSystem();
    checkKind(found);
  }

  std::string read(std::uintmax_t most_bytes) const {
    const Descriptor opened(::open(file_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat found = {};
    if (!opened.open() || ::fstat(opened.number(), &found) != 0) failSystem();
    checkKind(found);
    const auto bytes = static_cast<std::uintmax_t>(found.st_size);
    if (bytes > most_bytes) {
      const std::string most = std::to_string(most_bytes >> 20) + " MiB";
      throw InputError(inFile(file_),
                       fmt::format("is larger than {0}, expected {1} of at most {0}", most, expected_));
    }
    std::string text(bytes, '\0');
    if (bytes == 0) return text;
    std::size_t done = 0;
    while (done < bytes) {
      const std::size_t got = readSome(opened, text.data() + done, bytes - done);
      if (got == 0) fail("shrinks while it is read");
      done += got;
    }
    char more = 0;
    if (readSome(opened, &more, 1) > 0) fail("grows while it is read");
    return text;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(inFile(file_), what + ", expected " + expected_);
  }

  [[noreturn]] void failSystem() const {
    if (errno == ENOENT || errno == ENOTDIR) fail("no such file");
    fail(std::string("cannot be read (") + std::strerror(errno) + ")");
  }

  void checkKind(const struct stat& found) const {
    if (S_ISDIR(found.st_mode)) fail("is a folder");
    if (!S_ISREG(found.st_mode)) fail("is no regular file");
  }

  std::size_t readSome(const Descriptor& from, char* bytes, std::size_t count) const {
    for (;;) {
      const ssize_t got = ::read(from.number(), bytes, count);
      if (got >= 0) return static_cast<std::size_t>(got);
      if (errno != EINTR) failSystem();
    }
  }

  const fs::path& file_;
  const std::string& expected_;
};

}  // namespace

void requireInputFile(const fs::path& file, const std::string& expected) {
  const InputFile looked_at(file, expected);
}

std::string readInputFile(const fs::path& file, const std::string& expected, std::uintmax_t most_bytes) {
  return InputFile(file, expected).read(most_bytes);
}

}  // namespace fissure
