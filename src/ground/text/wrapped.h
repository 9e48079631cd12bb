#pragma once

#include <cstddef>
#include <string>

namespace fissure {

/// Wraps the words of `text` into lines of at most `width` columns, with a line end after the last. All lines
/// but the first begin with `indent` blanks; the first is meant to be printed at column `indent`, behind what
/// the caller has written there. A word that is too long has a line of its own.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

}  // namespace fissure
