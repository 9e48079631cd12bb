#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fissure {

/// What a text that should be UTF-8 begins with.
struct Utf8Start {
  enum class Kind {
    character,   ///< a whole character
    bad_byte,    ///< a byte that begins none
    unfinished,  ///< the text ends within a character
  };
  Kind kind = Kind::character;
  std::size_t bytes = 1;
  std::uint32_t character = 0;  ///< Unicode's number of a whole one

  bool isWhole() const { return kind == Kind::character; }
};

/// Of a text that is not empty; by RFC 3629, without overlong forms and surrogates.
Utf8Start utf8Start(std::string_view text);

/// Whether a character controls a terminal or hides what a text says: C0 and C1 control characters, DEL, the
/// separators of lines and paragraphs, and what overrides, embeds or isolates the direction of writing.
bool isControl(std::uint32_t character);

/// Whether `text` is one line that shows what it says: UTF-8 without such characters.
bool isPlainLine(std::string_view text);

}  // namespace fissure
