#include "main/page_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/error.h"
#include "process/apart.h"
#include "store/durable_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// A file that is gone with this object, unless it was moved.
struct Temporary {
  explicit Temporary(fs::path name) : path(std::move(name)) {}
  ~Temporary() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  fs::path path;
};

void writeText(const fs::path& file, const fs::path& target, const std::string& text) {
  const auto fail = [&] { throw RunError(target.string() + ": cannot be written: " + std::strerror(errno)); };
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "wbe"), std::fclose);
  if (!stream) fail();
  if (std::fwrite(text.data(), 1, text.size(), stream.get()) != text.size()) fail();
  if (std::fclose(stream.release()) != 0) fail();
}

}  // namespace

void writePageApart(const fs::path& target, const std::function<std::string()>& make, unsigned long most_s) {
  const Temporary temporary(temporaryName(target, ::getpid(), 0));
  doApart([&] { writeText(temporary.path, target, make()); }, most_s);
  moveIntoPlace(temporary.path, target);
}

}  // namespace fissure
