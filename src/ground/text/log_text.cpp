#include "text/log_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "base/error.h"
#include "files/input_file.h"

namespace fissure {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::uintmax_t most_bytes = std::uintmax_t{256} << 20;  // an hour at 1 kHz has 200 MB at most

std::string_view trim(std::string_view cell) {
  const auto first = cell.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return cell.substr(first, cell.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::string readLogText(const std::filesystem::path& file) {
  std::string text = readInputFile(file, "a text file of numbers", most_bytes);
  if (text.find('\0') != std::string::npos)
    throw InputError(inFile(file), "is binary (it holds NUL bytes), expected plain text, UTF-8 or ASCII");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

const std::string& LogFiles::text(const std::filesystem::path& file) const {
  const auto known = texts_.find(file);
  return known != texts_.end() ? known->second : texts_.emplace(file, readLogText(file)).first->second;
}

char findDelimiter(std::string_view line) {
  constexpr std::string_view candidates = ",;\t";
  std::array<int, 3> counts = {0, 0, 0};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    const auto which = candidates.find(c);
    if (!quoted && which != std::string_view::npos) ++counts[which];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return *most == 0 ? ' ' : candidates[static_cast<std::size_t>(most - counts.begin())];
}

void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  cells.clear();
  const std::string_view dividers = delimiter == ' ' ? blanks : std::string_view(&delimiter, 1);
  for (std::size_t start = 0; start <= line.size();) {
    if (delimiter == ' ') start = std::min(line.find_first_not_of(blanks, start), line.size());
    if (delimiter == ' ' && start == line.size()) break;
    const std::size_t content = std::min(line.find_first_not_of(' ', start), line.size());
    std::size_t from = start, end = 0;
    if (content < line.size() && line[content] == '"') {
      from = content + 1;
      end = std::min(line.find('"', from), line.size());
    } else {
      end = std::min(line.find_first_of(dividers, start), line.size());
    }
    cells.push_back(trim(line.substr(from, end - from)));
    start = std::min(line.find_first_of(dividers, end), line.size()) + 1;
  }
}

bool takeLogLine(std::string_view text, std::size_t& position, std::string_view& line) {
  if (position >= text.size()) return false;
  const std::size_t end = std::min(text.find('\n', position), text.size());
  line = text.substr(position, end - position);
  if (line.ends_with('\r')) line.remove_suffix(1);
  position = end + 1;
  return true;
}

double logNumber(std::string_view cell, const std::string& file, int line, const std::string& in) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::string_view digits = cell;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    digits.remove_prefix(1);  // from_chars takes no plus
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw InputError(
        inFile(file, line),
        fmt::format("\"{}\" in {}, expected a number like -0.0125 or nothing", logExcerpt(cell), in));
  return value;
}

std::string logExcerpt(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string shown(text.substr(0, most));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() <= most ? shown : shown + "...";
}

}  // namespace fissure
