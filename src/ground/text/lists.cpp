#include "text/lists.h"

namespace fissure {

std::string inWords(const std::vector<std::string_view>& items, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0 && i + 1 < items.size()) text.append(", ");
    if (i > 0 && i + 1 == items.size()) text.append(" ").append(last).append(" ");
    text.append(items[i]);
  }
  return text;
}

std::string withNoun(std::string_view noun, const std::vector<std::string_view>& items) {
  return std::string(noun).append(items.size() == 1 ? " " : "s ").append(inWords(items));
}

}  // namespace fissure
