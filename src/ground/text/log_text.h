#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// The whole text of a log, without a byte order mark. Throws InputError when the file is missing,
/// unreadable, no regular file, larger than 256 MiB, or binary.
std::string readLogText(const std::filesystem::path& file);

/// A cache of the texts of logs: each file is read once, when it is first asked for.
class LogFiles {
 public:
  /// As readLogText. The reference is valid as long as this object.
  const std::string& text(const std::filesystem::path& file) const;

 private:
  mutable std::map<std::filesystem::path, std::string> texts_;
};

/// The delimiter of a line's cells: the most frequent of comma, semicolon and tab outside double quotes, or a
/// blank where there is none of these.
char findDelimiter(std::string_view line);

/// Replaces `cells` by the cells of a line, without quotes and surrounding blanks; they are views into
/// `line`. The delimiter ' ' stands for runs of blanks.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

/// Sets `line` to the line at `position` and moves `position` behind it; returns false at the end of the
/// text.
bool takeLogLine(std::string_view text, std::size_t& position, std::string_view& line);

/// Parses a number with a decimal point, in every locale; NaN for an empty cell. Throws InputError with file
/// and line when the cell holds anything else; `in` tells the message where the cell is, as `column "x"`.
double logNumber(std::string_view cell, const std::string& file, int line, const std::string& in);

/// An excerpt of a log for an error message of one line: short, and without bytes that control a terminal.
std::string logExcerpt(std::string_view text);

}  // namespace fissure
