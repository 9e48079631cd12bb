#include "base/utf8.h"

#include <algorithm>
#include <array>

namespace fissure {

namespace {

struct Range {
  std::uint32_t first = 0, last = 0;
};

constexpr std::array<Range, 5> controls = {{{0x00, 0x1f},
                                            {0x7f, 0x9f},
                                            {0x2028, 0x2029},    // separators of lines and paragraphs
                                            {0x202a, 0x202e},    // embeddings and overrides of direction
                                            {0x2066, 0x2069}}};  // isolates

}  // namespace

Utf8Start utf8Start(std::string_view text) {
  using Kind = Utf8Start::Kind;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {Kind::character, 1, lead};
  if (lead < 0xc2 || lead > 0xf4) return {Kind::bad_byte};
  const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  const unsigned char least_second = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
  const unsigned char most_second = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
  std::uint32_t character = lead & (0x7fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if (i == text.size()) return {Kind::unfinished, i};
    const bool second = i == 1;
    if (byte(i) < (second ? least_second : 0x80) || byte(i) > (second ? most_second : 0xbf))
      return {Kind::bad_byte};
    character = character << 6 | (byte(i) & 0x3fu);
  }
  return {Kind::character, size, character};
}

bool isControl(std::uint32_t character) {
  return std::any_of(controls.begin(), controls.end(),
                     [&](const Range& range) { return character >= range.first && character <= range.last; });
}

bool isPlainLine(std::string_view text) {
  while (!text.empty()) {
    const Utf8Start start = utf8Start(text);
    if (!start.isWhole() || isControl(start.character)) return false;
    text.remove_prefix(start.bytes);
  }
  return true;
}

}  // namespace fissure
