#include "motion/delimited_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <system_error>

#include "base/error.h"
#include "scenario/did_you_mean.h"

namespace fissure {
namespace {

constexpr std::string_view blanks = " \t";

std::string readAll(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw InputError(file.string() + ": no such file, expected a log");
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": is a folder, expected a log");
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::vector<char> block(1 << 20);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  if (!in.eof()) throw InputError(file.string() + ": cannot be read");
  return text;
}

std::string_view trim(std::string_view cell) {
  const auto first = cell.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return cell.substr(first, cell.find_last_not_of(blanks) - first + 1);
}

/// What divides the names of the header; delimiters inside quotes belong to a name.
char findDelimiter(std::string_view header) {
  constexpr std::string_view candidates = ",;\t";
  std::array<int, 3> counts = {0, 0, 0};
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    const auto which = candidates.find(c);
    if (!quoted && which != std::string_view::npos) ++counts[which];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return *most == 0 ? ' ' : candidates[static_cast<std::size_t>(most - counts.begin())];
}

/// Text of a foreign file, fit for a message of one line: short, and without bytes that control a terminal.
std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string shown(text.substr(0, most));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() <= most ? shown : shown + "...";
}

/// What to say to who asked for a column that is not there.
std::string missingColumn(const std::string& name, const std::vector<std::string>& names) {
  constexpr std::size_t most = 30;
  std::string has;
  std::vector<std::string> known;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    has += (i ? ", " : "") + excerpt(names[i]);
    if (!names[i].empty()) known.push_back(excerpt(names[i]));
  }
  if (names.size() > most) has += ", ...";
  const std::string advice = didYouMean(name, known);
  return "no column \"" + name + "\" in the header (it has " + has + ")" +
         (advice.ends_with('?') ? advice : ", expected one of these");
}

}  // namespace

DelimitedText::DelimitedText(const std::filesystem::path& file) : file_(file.string()), text_(readAll(file)) {
  if (text_.find('\0') != std::string::npos)
    throw InputError(file_ + ": is binary (it holds NUL bytes), expected plain text, UTF-8 or ASCII");
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;
  std::string_view header;
  if (!takeLine(header)) throw InputError(file_ + ": is empty, expected a header line of column names");
  delimiter_ = findDelimiter(header);
  split(header);
  for (const std::string_view name : cells_) names_.emplace_back(name);
  while (!names_.empty() && names_.back().empty()) names_.pop_back();  // a trailing delimiter
  if (names_.empty()) throw InputError(file_, line_, "an empty line, expected a header line of column names");
}

std::size_t DelimitedText::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw InputError(file_, 1, missingColumn(name, names_));
  if (std::find(found + 1, names_.end(), name) != names_.end())
    throw InputError(file_, 1, "two columns are called \"" + name + "\", expected one");
  return static_cast<std::size_t>(found - names_.begin());
}

bool DelimitedText::next() {
  std::string_view line;
  do {
    if (!takeLine(line)) return false;
    // In a file divided by tabs a line of tabs is a row of empty cells, which takes its time like any other
    // row.
  } while (line.find_first_not_of(delimiter_ == '\t' ? " " : blanks) == std::string_view::npos);
  split(line);
  const auto extra = cells_.begin() + static_cast<std::ptrdiff_t>(std::min(names_.size(), cells_.size()));
  if (std::any_of(extra, cells_.end(), [](std::string_view cell) { return !cell.empty(); }))
    throw InputError(file_, line_,
                     std::to_string(cells_.size()) + " cells, expected the " + std::to_string(names_.size()) +
                         " of the header");
  return true;
}

double DelimitedText::number(std::size_t column) const {
  if (column >= cells_.size() || cells_[column].empty()) return std::numeric_limits<double>::quiet_NaN();
  std::string_view cell = cells_[column];
  if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);  // from_chars takes no plus
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    throw InputError(file_, line_,
                     "\"" + excerpt(cells_[column]) + "\" in column \"" + names_[column] +
                         "\", expected a number like -0.0125 or nothing");
  return value;
}

bool DelimitedText::takeLine(std::string_view& line) {
  if (position_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  line = std::string_view(text_).substr(position_, end - position_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  position_ = end + 1;
  ++line_;
  return true;
}

void DelimitedText::split(std::string_view line) {
  cells_.clear();
  const std::string_view dividers = delimiter_ == ' ' ? blanks : std::string_view(&delimiter_, 1);
  for (std::size_t start = 0; start <= line.size();) {
    if (delimiter_ == ' ') start = std::min(line.find_first_not_of(blanks, start), line.size());
    if (delimiter_ == ' ' && start == line.size()) break;
    const std::size_t content = std::min(line.find_first_not_of(' ', start), line.size());
    std::size_t from = start, end = 0;
    if (content < line.size() && line[content] == '"') {
      from = content + 1;
      end = std::min(line.find('"', from), line.size());
    } else {
      end = std::min(line.find_first_of(dividers, start), line.size());
    }
    cells_.push_back(trim(line.substr(from, end - from)));
    start = std::min(line.find_first_of(dividers, end), line.size()) + 1;
  }
}

}  // namespace fissure
