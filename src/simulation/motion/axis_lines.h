#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "text/log_table.h"
#include "text/log_text.h"

namespace fissure {

/// A log without column names and times: three lines of numbers, all x, all y and all z, as Falcon drivers
/// dump them. Delimiters, trailing delimiters, CRLF and empty lines are treated as in DelimitedText. Where
/// one line is shorter than the others, the samples beyond its end have no pose. The columns are "x", "y" and
/// "z".
class AxisLines : public LogTable {
 public:
  /// Reads the file. Throws InputError, with the line number, when there are not three lines of numbers.
  explicit AxisLines(const std::filesystem::path& file, const LogFiles& files = LogFiles());

  std::size_t column(const std::string& name) const override;
  bool next() override;
  double number(std::size_t column) const override;
  int line() const override { return 1; }
  const std::string& fileName() const override { return file_; }

 private:
  std::string file_;
  std::array<std::vector<double>, 3> axes_;
  std::size_t samples_ = 0;  ///< of the longest line
  std::size_t taken_ = 0;    ///< number of samples up to and including the current one
};

}  // namespace fissure
