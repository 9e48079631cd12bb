#pragma once

#include <filesystem>
#include <string>

namespace fissure {

/// Writes a whole file, replacing one that exists. Throws DiskError with the file's name and the system's
/// reason (no space left, too many open files ...).
void writeFile(const std::filesystem::path& file, const std::string& text);

/// The same, but the file appears with all of the text, or stays as it was (TemporaryFile); what killed
/// processes have left of their attempts is removed.
void replaceFile(const std::filesystem::path& file, const std::string& text);

/// As writeFile(), but returns false where writeFile() throws; errno has the reason.
bool tryWritingFile(const std::filesystem::path& file, const std::string& text);

}  // namespace fissure
