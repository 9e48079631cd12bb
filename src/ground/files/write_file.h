#pragma once

#include <filesystem>
#include <string>

namespace fissure {

/// Writes a whole file, replacing one that exists. Throws RunError with the file's name and the system's
/// reason (no space left, too many open files ...).
void writeFile(const std::filesystem::path& file, const std::string& text);

/// The same, but returns false where writeFile() throws; errno has the reason.
bool tryWritingFile(const std::filesystem::path& file, const std::string& text);

}  // namespace fissure
