#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "text/log_table.h"
#include "text/log_text.h"

namespace fissure {

/// Reads the numbers of a text file that has one header line of column names and then one row per line. The
/// delimiter is the most frequent of comma, semicolon and tab in the header, or else runs of blanks.
/// Tolerated: a UTF-8 byte order mark, CRLF, names and cells in double quotes or padded with blanks, a
/// trailing delimiter, rows shorter than the header, empty lines, comments (lines that begin with #).
/// Refused: rows with more cells than names.
class DelimitedText : public LogTable {
 public:
  /// Reads the file and its header. Throws InputError when the file is missing, unreadable, empty or binary.
  explicit DelimitedText(const std::filesystem::path& file, const LogFiles& files = LogFiles());
  DelimitedText(const DelimitedText&) = delete;  // cells_ points into text_
  DelimitedText& operator=(const DelimitedText&) = delete;

  /// Index of a named column. Throws InputError, which lists the header's names, when the name is missing or
  /// stands there twice.
  std::size_t column(const std::string& name) const override;

  /// Moves to the next row; returns false after the last one. Throws InputError with the line number when the
  /// row has more cells than the header has names.
  bool next() override;

  /// The number in this row and column; NaN where the cell is empty or absent. Numbers have a decimal point,
  /// in every locale. Throws InputError with the line number when the cell holds anything else.
  double number(std::size_t column) const override;
  /// The text of the cell without quotes; empty where it is absent. Valid until the next row.
  std::string_view text(std::size_t column) const;

  /// The column names, in the order of the header.
  const std::vector<std::string>& names() const { return names_; }
  int headerLine() const { return header_line_; }

  /// Line number of this row in the file, from 1.
  int line() const override { return line_; }
  const std::string& fileName() const override { return file_; }

 private:
  bool takeLine(std::string_view& line);

  std::string file_;
  std::string text_;
  std::size_t position_ = 0;
  int line_ = 0;
  int header_line_ = 0;
  char delimiter_ = ' ';
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;  ///< cells of this row: views into text_
};

}  // namespace fissure
