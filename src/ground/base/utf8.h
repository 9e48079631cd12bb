#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fissure {

/// The first character or bad byte of a text that should be UTF-8.
struct Utf8Start {
  enum class Kind {
    character,   ///< a whole character
    bad_byte,    ///< a byte that begins none
    unfinished,  ///< the text ends within a character
  };
  Kind kind = Kind::character;
  /// Length of the character, or of the bytes to skip.
  std::size_t bytes = 1;
  std::uint32_t character = 0;  ///< Unicode code point of a whole character, else 0

  bool isWhole() const { return kind == Kind::character; }
};

/// The start of `text`, which must not be empty, by RFC 3629: overlong forms and surrogates are bad bytes.
Utf8Start utf8Start(std::string_view text);

/// Whether a character controls a terminal or hides part of a text: C0 and C1 control characters, DEL, the
/// separators of lines and paragraphs, and characters that override, embed or isolate the direction of
/// writing.
bool isControl(std::uint32_t character);

/// Whether `text` is one line of valid UTF-8 without control characters (isControl).
bool isPlainLine(std::string_view text);

}  // namespace fissure
