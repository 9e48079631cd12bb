#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// The whole text of a log, without a byte order mark. Throws InputError when it is missing, unreadable, no
/// regular file, larger than 256 MiB, or binary.
std::string readLogText(const std::filesystem::path& file);

/// The texts of logs, each file read once: when it is first asked for.
class LogFiles {
 public:
  /// As readLogText. The reference holds as long as this object.
  const std::string& text(const std::filesystem::path& file) const;

 private:
  mutable std::map<std::filesystem::path, std::string> texts_;
};

/// What divides the cells of a line: the most frequent of comma, semicolon and tab outside double quotes, or
/// else blanks.
char findDelimiter(std::string_view line);

/// The cells of a line, without quotes and the blanks around them; `delimiter` ' ' stands for runs of blanks.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

/// Takes the line at `position` and moves behind it; false at the end of the text.
bool takeLogLine(std::string_view text, std::size_t& position, std::string_view& line);

/// A number with a decimal point, in every locale; NaN for an empty cell. Throws InputError with file and
/// line when the cell holds anything else; `in`: where it stands, as in `column "x"`.
double logNumber(std::string_view cell, const std::string& file, int line, const std::string& in);

/// Text of a foreign file, fit for a message of one line: short, and without bytes that control a terminal.
std::string logExcerpt(std::string_view text);

}  // namespace fissure
