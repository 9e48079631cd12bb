#include "files/write_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "files/disk_error.h"

namespace fissure {

void writeFile(const std::filesystem::path& file, const std::string& text) {
  if (!tryWritingFile(file, text)) throw DiskError(file.string() + ": cannot write: " + std::strerror(errno));
}

void replaceFile(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::path part = file;
  part += ".part";
  if (tryWritingFile(part, text) && std::rename(part.c_str(), file.c_str()) == 0) return;
  const std::string reason = std::strerror(errno);
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw DiskError(file.string() + ": cannot write: " + reason);
}

bool tryWritingFile(const std::filesystem::path& file, const std::string& text) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "wbe"), std::fclose);
  return stream && std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
         std::fclose(stream.release()) == 0;
}

}  // namespace fissure
