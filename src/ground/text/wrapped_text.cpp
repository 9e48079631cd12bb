#include "text/wrapped_text.h"

namespace fissure {

std::string wrappedText(const std::vector<std::string>& words, std::size_t indent) {
  constexpr std::size_t most = 100;
  std::string text, line(indent, ' ');
  for (const std::string& word : words) {
    const bool is_first = line.find_first_not_of(' ') == std::string::npos;
    if (!is_first && line.size() + 1 + word.size() > most) {
      text += line + "\n";
      line = std::string(indent + 4, ' ') + word;
    } else {
      line += (is_first ? "" : " ") + word;
    }
  }
  return text + line + "\n";
}

}  // namespace fissure
