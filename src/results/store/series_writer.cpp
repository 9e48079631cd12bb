#include "store/series_writer.h"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace fissure {

namespace {

constexpr std::size_t largest_chunk = 4096;
const std::string timing_prefix = "timing/";

bool isTiming(const Series& series) {
  return series.name.starts_with(timing_prefix);
}

// Axes before time in the dataset: the law, where a series has one.
std::size_t axesBeforeTime(const Series& series) {
  return !series.axes.empty() && series.axes.front() == "law" ? 1 : 0;
}

const Series& timeSeries(const RecordLayout& layout) {
  const Series* time = layout.find("time");
  if (!time || time->type != ValueType::real || !time->axes.empty()) {
    throw std::logic_error("a record needs a series 'time' of one real value a row");
  }
  return *time;
}

DatasetSpec specOf(const Series& series, const std::string& name, const RecordLayout& layout,
                   std::size_t chunk_rows) {
  DatasetSpec spec{name, series.units, series.long_name, series.type, {}};
  for (const std::string& axis : series.axes)
    spec.dimensions.push_back({axis, layout.axis(axis).labels.size()});
  const auto time_at = spec.dimensions.begin() + static_cast<std::ptrdiff_t>(axesBeforeTime(series));
  spec.dimensions.insert(time_at, {"time", chunk_rows, true});
  return spec;
}

template <typename Value>
Value converted(double value, const Series& series) {
  if constexpr (std::is_same_v<Value, double>) return value;
  // Exact in a double up to 2^53; the comparison is false for NaN.
  const double largest = std::is_same_v<Value, std::uint8_t> ? 255.0 : 9007199254740992.0;
  const double smallest = std::is_same_v<Value, std::uint8_t> ? 0.0 : -largest;
  if (!(value >= smallest && value <= largest && value == std::trunc(value))) {
    throw std::logic_error("series " + series.name + " holds counts or flags, not " + std::to_string(value));
  }
  return static_cast<Value>(value);
}

}  // namespace

std::size_t rowsInChunk(std::size_t expected_rows) {
  if (expected_rows == 0) return 1024;
  const std::size_t chunks = (expected_rows + largest_chunk - 1) / largest_chunk;
  return (expected_rows + chunks - 1) / chunks;
}

SeriesWriter::SeriesWriter(GroupBuilder& group, const RecordLayout& layout, std::size_t chunk_rows)
    : columns_(layout.columns()), chunk_rows_(chunk_rows) {
  const auto add = [&](GroupBuilder& to, const Series& series, const std::string& name) {
    for (const std::string& axis : series.axes) to.addLabels(axis, layout.axis(axis).labels);
    std::size_t leading = 1;
    if (axesBeforeTime(series) == 1) leading = layout.axis(series.axes.front()).labels.size();
    return Column{series, leading, to.addGrowing(specOf(series, name, layout, chunk_rows))};
  };
  const Series& time = timeSeries(layout);
  time_.push_back(add(group, time, "time"));
  std::optional<GroupBuilder> timing;
  for (const Series& series : layout.series()) {
    if (series.name == "time") continue;
    if (!isTiming(series)) {
      if (series.name.find('/') != std::string::npos) throw std::logic_error("unknown group: " + series.name);
      series_.push_back(add(group, series, series.name));
      continue;
    }
    if (!timing) {
      timing.emplace(group.id(), "timing");
      series_.push_back(add(*timing, time, "time"));
    }
    series_.push_back(add(*timing, series, series.name.substr(timing_prefix.size())));
  }
  buffer_.reserve(columns_ * chunk_rows_);
}

bool SeriesWriter::append(const RecordRow& row) {
  if (row.size() != columns_) throw std::logic_error("a row of the record does not fit its layout");
  buffer_.insert(buffer_.end(), row.begin(), row.end());
  if (++rows_in_chunk_ < chunk_rows_) return false;
  rows_in_chunk_ = 0;
  return true;
}

template <typename Value>
std::vector<Value> SeriesWriter::gather(const Column& column) const {
  const Series& series = column.series;
  const std::size_t trailing = column.leading == 0 ? 0 : series.columns / column.leading;
  std::vector<Value> values;
  values.reserve(rows() * series.columns);
  for (std::size_t slice = 0; slice < column.leading; ++slice) {
    for (std::size_t row = 0; row < rows(); ++row) {
      const double* from = &buffer_[row * columns_ + series.first_column + slice * trailing];
      for (std::size_t i = 0; i < trailing; ++i) values.push_back(converted<Value>(from[i], series));
    }
  }
  return values;
}

void SeriesWriter::write(Column& column) const {
  switch (column.series.type) {
    case ValueType::real:
      return column.dataset.append(gather<double>(column).data(), rows());
    case ValueType::count:
      return column.dataset.append(gather<std::int64_t>(column).data(), rows());
    case ValueType::flag:
      return column.dataset.append(gather<std::uint8_t>(column).data(), rows());
  }
}

void SeriesWriter::writeData() {
  if (rows() == 0) return;
  for (Column& column : series_) write(column);
}

void SeriesWriter::writeTime() {
  if (rows() == 0) return;
  write(time_.front());
  buffer_.clear();
}

}  // namespace fissure
