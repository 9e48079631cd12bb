#pragma once

#include <filesystem>
#include <string>

namespace fissure {

/// The whole of a text file. Throws InputError when it does not exist, is a folder or cannot be read, or is
/// larger than 64 MiB (then it is no scenario).
std::string readTextFile(const std::filesystem::path& file);

/// Line, from 1, of the first byte that does not belong in UTF-8 text (control characters other than tab and
/// line ends do not either); 0 when all is text.
int firstLineNotText(const std::string& text);

}  // namespace fissure
