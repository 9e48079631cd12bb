#include "text/delimited_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "text/did_you_mean.h"

namespace fissure {
namespace {

/// What to say to who asked for a column that is not there.
std::string missingColumn(const std::string& name, const std::vector<std::string>& names) {
  constexpr std::size_t most = 30;
  std::string has;
  std::vector<std::string> known;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    has += (i ? ", " : "") + logExcerpt(names[i]);
    if (!names[i].empty()) known.push_back(logExcerpt(names[i]));
  }
  if (names.size() > most) has += ", ...";
  const std::string advice = didYouMean(name, known);
  return fmt::format("no column \"{}\" in the header (it has {}){}", name, has,
                     advice.ends_with('?') ? advice : ", expected one of these");
}

}  // namespace

DelimitedText::DelimitedText(const std::filesystem::path& file, const LogFiles& files)
    : file_(file.string()), text_(files.text(file)) {
  std::string_view header;
  if (!takeLine(header)) throw InputError(inFile(file_), "is empty, expected a header line of column names");
  header_line_ = line_;
  delimiter_ = findDelimiter(header);
  splitCells(header, delimiter_, cells_);
  for (const std::string_view name : cells_) names_.emplace_back(name);
  while (!names_.empty() && names_.back().empty()) names_.pop_back();  // a trailing delimiter
  if (names_.empty())
    throw InputError(inFile(file_, line_), "an empty line, expected a header line of column names");
}

std::size_t DelimitedText::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw InputError(inFile(file_, header_line_), missingColumn(name, names_));
  if (std::find(found + 1, names_.end(), name) != names_.end())
    throw InputError(inFile(file_, header_line_),
                     "two columns are called \"" + logExcerpt(name) + "\", expected one");
  return static_cast<std::size_t>(found - names_.begin());
}

bool DelimitedText::next() {
  std::string_view line;
  do {
    if (!takeLine(line)) return false;
    // In a file divided by tabs a line of tabs is a row of empty cells, which takes its time like any other
    // row.
  } while (line.find_first_not_of(delimiter_ == '\t' ? " " : " \t") == std::string_view::npos);
  splitCells(line, delimiter_, cells_);
  const auto extra = cells_.begin() + static_cast<std::ptrdiff_t>(std::min(names_.size(), cells_.size()));
  if (std::any_of(extra, cells_.end(), [](std::string_view cell) { return !cell.empty(); }))
    throw InputError(inFile(file_, line_),
                     fmt::format("{} cells, expected the {} of the header", cells_.size(), names_.size()));
  return true;
}

std::string_view DelimitedText::text(std::size_t column) const {
  return column < cells_.size() ? cells_[column] : std::string_view();
}

double DelimitedText::number(std::size_t column) const {
  if (column >= cells_.size()) return std::numeric_limits<double>::quiet_NaN();
  return logNumber(cells_[column], file_, line_, "column \"" + logExcerpt(names_[column]) + "\"");
}

bool DelimitedText::takeLine(std::string_view& line) {
  do {
    if (!takeLogLine(text_, position_, line)) return false;
    ++line_;
  } while (line.starts_with('#'));
  return true;
}

}  // namespace fissure
