#include "store/sweep_csv.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/error.h"
#include "scenario/scalars.h"
#include "store/temporary_file.h"

namespace fissure {

namespace {

constexpr std::size_t block_rows = 1024;

struct Column {
  std::string name;
  bool numeric = true;
};

std::vector<Column> columnsOf(const SweepTableLayout& layout) {
  std::vector<Column> columns = {{"run"}, {"point"}, {"pipeline", false}, {"repeat"}};
  for (const SweepAxisColumn& axis : layout.axes) columns.push_back({axis.name, axis.numeric});
  for (const char* name : {"status", "status_detail", "file"}) columns.push_back({name, false});
  for (const SweepMetric& metric : layout.metrics)
    if (!metric.name.starts_with("timing/")) columns.push_back({metric.name});
  return columns;
}

std::string numberField(double number) {
  return std::isnan(number) ? "" : formatReal(number);
}

/// The fields of some rows of a column.
std::vector<std::string> fields(const SweepTable& table, const Column& column, std::size_t first,
                                std::size_t count) {
  std::vector<std::string> made;
  if (column.numeric) {
    for (const double number : table.numbers(column.name, first, count)) made.push_back(numberField(number));
  } else {
    for (const std::string& text : table.texts(column.name, first, count)) made.push_back(csvField(text));
  }
  return made;
}

void writeRows(std::ofstream& stream, const SweepTable& table, const std::vector<Column>& columns) {
  for (std::size_t first = 0; first < table.runs(); first += block_rows) {
    const std::size_t count = std::min(block_rows, table.runs() - first);
    std::vector<std::string> lines(count);
    for (const Column& column : columns) {
      const std::vector<std::string> made = fields(table, column, first, count);
      for (std::size_t i = 0; i < count; ++i) lines[i] += (&column == &columns.front() ? "" : ",") + made[i];
    }
    for (const std::string& line : lines) stream << line << '\n';
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
  for (const Column& column : columns)
    stream << (&column == &columns.front() ? "" : ",") << csvField(column.name);
  stream << '\n';
  writeRows(stream, table, columns);
  errno = 0;
  stream.close();
  if (!stream) throw RunError(std::string("cannot write: ") + std::strerror(errno != 0 ? errno : EIO));
  temporary.commit();
} catch (const RunError& error) {
  throw RunError(path.string() + ": " + error.what());
}

}  // namespace fissure
