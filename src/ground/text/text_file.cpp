#include "text/text_file.h"

#include "base/utf8.h"
#include "files/input_file.h"

namespace fissure {

std::string readTextFile(const std::filesystem::path& file, std::uintmax_t most_bytes) {
  return readInputFile(file, "a text file", most_bytes);
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
