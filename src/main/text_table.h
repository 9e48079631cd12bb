#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fissure {

using TextRow = std::vector<std::string>;

/// Rows of equal length as aligned lines: the first `left` columns are left-aligned, the others right-aligned
/// (the last one left-aligned where `last_left`), with two blanks between columns and none at line ends.
/// Where standard output is a terminal that is too narrow, the columns are split into several tables, each
/// with the first column.
std::string alignedText(const std::vector<TextRow>& rows, std::size_t left, bool last_left = false);

/// A size for people: "12 B", "3.1 MB".
std::string sizeText(double bytes);

}  // namespace fissure
