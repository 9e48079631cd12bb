#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fissure {

using TextRow = std::vector<std::string>;

/// Rows of equal length as lines: the first `left` columns to the left, the others to the right (the last one
/// to the left too where `last_left`), two blanks between columns, none at the ends of lines.
std::string alignedText(const std::vector<TextRow>& rows, std::size_t left, bool last_left = false);

/// "12 B", "3.1 MB".
std::string sizeText(double bytes);

}  // namespace fissure
