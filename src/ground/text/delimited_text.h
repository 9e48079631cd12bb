#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "text/log_table.h"
#include "text/log_text.h"

namespace fissure {

/// Reads the numbers of a text file with one header line of column names and one row a line. Cells are
/// divided by what the header divides its names with: commas, semicolons, tabs (the most frequent of them) or
/// else runs of blanks. Tolerated: a UTF-8 byte order mark, CRLF, names and cells in double quotes or padded
/// with blanks, a trailing delimiter, rows shorter than the header, empty lines, comments (lines that begin
/// with #). Refused: rows with more cells than names.
class DelimitedText : public LogTable {
 public:
  /// Reads the file and its header. Throws InputError when it is missing, unreadable, empty or binary.
  explicit DelimitedText(const std::filesystem::path& file, const LogFiles& files = LogFiles());
  DelimitedText(const DelimitedText&) = delete;  // cells_ points into text_
  DelimitedText& operator=(const DelimitedText&) = delete;

  /// Index of a named column. Throws InputError, with the header's names, when it is missing or there twice.
  std::size_t column(const std::string& name) const override;

  /// Moves to the next row; false after the last one. Throws InputError with the line when it has too many
  /// cells.
  bool next() override;

  /// The cell of this row in a column; NaN where it is empty or absent. Numbers have a decimal point, in
  /// every locale. Throws InputError with the line when it holds anything else.
  double number(std::size_t column) const override;
  /// The cell as it stands, without quotes; empty where it is absent. Until the next row.
  std::string_view text(std::size_t column) const;

  /// Of the header, in its order.
  const std::vector<std::string>& names() const { return names_; }
  int headerLine() const { return header_line_; }

  /// Of this row, from 1.
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
  std::vector<std::string_view> cells_;  ///< of this row, into text_
};

}  // namespace fissure
