#pragma once

#include <filesystem>
#include <string>

namespace fissure {

/// Writes a whole file of this program's own, over one that is there. Throws RunError with the file's name
/// and the system's reason: no space left, too many open files ...
void writeFile(const std::filesystem::path& file, const std::string& text);

/// The same, but false where writeFile() throws; errno says why.
bool tryWritingFile(const std::filesystem::path& file, const std::string& text);

}  // namespace fissure
