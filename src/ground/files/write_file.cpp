#include "files/write_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "files/disk_error.h"
#include "files/temporary_file.h"

namespace fissure {

void writeFile(const std::filesystem::path& file, const std::string& text) {
  if (!tryWritingFile(file, text)) throw DiskError(file.string() + ": cannot write: " + std::strerror(errno));
}

void replaceFile(const std::filesystem::path& file, const std::string& text) {
  try {
    TemporaryFile temporary(file);
    temporary.write(text);
    temporary.commit();
    removeAbandoned(file);
  } catch (const RunError& error) {
    throw DiskError(file.string() + ": " + error.what());
  }
}

bool tryWritingFile(const std::filesystem::path& file, const std::string& text) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "wbe"), std::fclose);
  return stream && std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
         std::fclose(stream.release()) == 0;
}

}  // namespace fissure
