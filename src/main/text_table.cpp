#include "main/text_table.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "process/progress_display.h"

namespace fissure {

std::string alignedText(const std::vector<TextRow>& rows, std::size_t left, bool last_left) {
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size(), 0);
  for (const TextRow& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  const std::size_t most = terminalColumns(STDOUT_FILENO).value_or(std::string::npos);
  std::string text;
  std::vector<std::size_t> block = {0};
  std::size_t width = widths.empty() ? 0 : widths[0];
  const auto printBlock = [&] {
    text += text.empty() ? "" : "\n";
    for (const TextRow& row : rows) {
      std::string line;
      for (const std::size_t c : block) {
        const std::string blanks(widths[c] - row[c].size(), ' ');
        const bool to_left = c < left || (last_left && c + 1 == row.size());
        line += (c > 0 ? "  " : "") + (to_left ? row[c] + blanks : blanks + row[c]);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + "\n";
    }
  };
  for (std::size_t c = 1; c < widths.size(); ++c) {
    if (block.size() > 1 && width + 2 + widths[c] > most) {
      printBlock();
      block = {0};
      width = widths[0];
    }
    block.push_back(c);
    width += 2 + widths[c];
  }
  printBlock();
  return text;
}

std::string sizeText(double bytes) {
  constexpr std::array<const char*, 5> units = {"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1000 && unit + 1 < units.size()) {
    bytes /= 1000;
    ++unit;
  }
  return fmt::format("{:.{}f} {}", bytes, unit == 0 ? 0 : 1, units[unit]);
}

}  // namespace fissure
