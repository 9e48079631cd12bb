#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace fissure {

/// The whole contents of a text file. Throws InputError as readInputFile does: about a file that is missing,
/// no regular file, or larger than `most_bytes`.
std::string readTextFile(const std::filesystem::path& file,
                         std::uintmax_t most_bytes = std::uintmax_t{64} << 20);

/// Line number, from 1, of the first byte that is no UTF-8 text; control characters other than tab and line
/// ends are no text either. 0 when all is text.
int firstLineNotText(const std::string& text);

}  // namespace fissure
