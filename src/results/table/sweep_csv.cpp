#include "table/sweep_csv.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/error.h"
#include "files/temporary_file.h"
#include "text/scalars.h"
#include "text/summary_unit.h"

namespace fissure {

namespace {

constexpr std::size_t rows_a_read = 4096;

enum class Field { number, count, text };

struct Column {
  std::string name;
  Field field;
};

std::vector<Column> columnsOf(const SweepTableLayout& layout) {
  std::vector<Column> columns = {
      {"run", Field::count}, {"point", Field::count}, {"pipeline", Field::text}, {"repeat", Field::count}};
  for (const SweepAxisColumn& axis : layout.axes)
    columns.push_back({axis.name, axis.numeric ? Field::number : Field::text});
  for (const char* name : {"status", "status_detail", "file"}) columns.push_back({name, Field::text});
  for (const SweepMetric& metric : layout.metrics)
    if (!metric.name.starts_with("timing/"))
      columns.push_back({metric.name, summaryUnit(metric.name) == "1" ? Field::count : Field::number});
  return columns;
}

constexpr double past_whole_numbers = 0x1p53;

/// Whole numbers of a count in digits: readers that want an integer refuse "1e+05".
std::string numberField(double number, Field field) {
  if (std::isnan(number)) return "";
  const bool whole = number == std::trunc(number) && std::abs(number) < past_whole_numbers;
  if (field == Field::count && whole && number != 0) return std::to_string(static_cast<std::int64_t>(number));
  return formatReal(number);
}

/// Appends the column's fields in the rows from `first` on to `lines`, one per row.
void appendFields(const SweepTable& table, const Column& column, std::size_t first,
                  std::vector<std::string>& lines) {
  if (column.field == Field::text) {
    const std::vector<std::string> texts = table.texts(column.name, first, lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i].append(csvField(texts[i]));
    return;
  }
  const std::vector<double> numbers = table.numbers(column.name, first, lines.size());
  std::string made;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // Runs that differ in a law alone have most of their numbers in common.
    if (i == 0 || std::bit_cast<std::uint64_t>(numbers[i]) != std::bit_cast<std::uint64_t>(numbers[i - 1]))
      made = numberField(numbers[i], column.field);
    lines[i].append(made);
  }
}

/// Puts `text` into the stream and on its way. Throws RunError with the system's reason.
void put(std::ofstream& stream, const std::string& text) {
  errno = 0;
  stream << text << std::flush;
  if (!stream) throw RunError(std::string("cannot write: ") + std::strerror(errno != 0 ? errno : EIO));
}

void writeRows(std::ofstream& stream, const SweepTable& table, const std::vector<Column>& columns) {
  std::vector<std::string> lines;
  std::string text;
  for (std::size_t first = 0; first < table.runs(); first += rows_a_read) {
    lines.resize(std::min(rows_a_read, table.runs() - first));
    for (std::string& line : lines) line.clear();
    for (const Column& column : columns) {
      if (&column != &columns.front())
        for (std::string& line : lines) line.push_back(',');
      appendFields(table, column, first, lines);
    }
    text.clear();
    for (const std::string& line : lines) text.append(line).append("\n");
    put(stream, text);
  }
}

}  // namespace

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + '"';
}

void writeSweepCsv(const std::filesystem::path& path, const SweepTable& table) try {
  TemporaryFile temporary(path);
  const std::vector<Column> columns = columnsOf(table.layout());
  std::ofstream stream(temporary.path(), std::ios::binary);
  if (!stream) throw RunError(std::string("cannot write: ") + std::strerror(errno));
  std::string names;
  for (const Column& column : columns)
    names.append(&column == &columns.front() ? "" : ",").append(csvField(column.name));
  put(stream, names + "\n");
  writeRows(stream, table, columns);
  errno = 0;
  stream.close();
  if (!stream) throw RunError(std::string("cannot write: ") + std::strerror(errno != 0 ? errno : EIO));
  temporary.commit();
} catch (const RunError& error) {
  throw RunError(path.string() + ": " + error.what());
}

}  // namespace fissure
