#include "text/text_file.h"

#include <fstream>
#include <system_error>

#include "base/error.h"
#include "base/utf8.h"

namespace fissure {

namespace {

constexpr std::size_t max_bytes = std::size_t{64} << 20;

}  // namespace

std::string readTextFile(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(inFile(file), "is a folder, expected a file");
  }
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
    throw InputError(inFile(file), "is no regular file, expected a text file");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    const bool exists = std::filesystem::exists(file, ignored);
    throw InputError(inFile(file),
                     std::string(exists ? "cannot be read" : "no such file") + ", expected a text file");
  }
  std::string text;
  char block[65536];
  while (in.read(block, sizeof block) || in.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > max_bytes) throw InputError(inFile(file), "larger than 64 MiB, expected a text file");
  }
  if (in.bad()) throw InputError(inFile(file), "cannot be read, expected a text file");
  return text;
}

int firstLineNotText(const std::string& text) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == '\n') ++line;
    const bool control = (byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t') || byte == 0x7f;
    const Utf8Start start = utf8Start(std::string_view(text).substr(i));
    if (control || !start.isWhole()) return line;
    i += start.bytes;
  }
  return 0;
}

}  // namespace fissure
