#include "motion/axis_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace fissure {

namespace {

constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};

std::vector<double> readNumbers(std::string_view text, const std::string& file, int line, const char* axis) {
  std::vector<std::string_view> cells;
  splitCells(text, findDelimiter(text), cells);
  while (!cells.empty() && cells.back().empty()) cells.pop_back();  // trailing delimiters
  std::vector<double> numbers;
  numbers.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    numbers.push_back(logNumber(cells[i], file, line, fmt::format("sample {} of {}", i, axis)));
  return numbers;
}

}  // namespace

AxisLines::AxisLines(const std::filesystem::path& file, const LogFiles& files) : file_(file.string()) {
  const std::string& text = files.text(file);
  std::size_t position = 0, found = 0;
  int line = 0;
  for (std::string_view content; takeLogLine(text, position, content);) {
    ++line;
    if (content.find_first_not_of(" \t") == std::string_view::npos) continue;
    if (found == axes_.size())
      throw InputError(inFile(file_, line), "a fourth line, expected three: all x, all y and all z");
    axes_[found] = readNumbers(content, file_, line, axis_names[found]);
    samples_ = std::max(samples_, axes_[found].size());
    ++found;
  }
  if (found < axes_.size())
    throw InputError(inFile(file_),
                     fmt::format("has {} lines of numbers, expected three: all x, all y and all z", found));
}

std::size_t AxisLines::column(const std::string& name) const {
  const auto known = std::find(axis_names.begin(), axis_names.end(), name);
  if (known == axis_names.end())
    throw InputError(inFile(file_), "has no column \"" + name + "\", expected x, y or z");
  return static_cast<std::size_t>(known - axis_names.begin());
}

bool AxisLines::next() {
  if (taken_ == samples_) return false;
  ++taken_;
  return true;
}

double AxisLines::number(std::size_t column) const {
  const std::vector<double>& axis = axes_[column];
  return taken_ <= axis.size() ? axis[taken_ - 1] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace fissure
