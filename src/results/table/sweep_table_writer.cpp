#include "table/sweep_table_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "base/error.h"
#include "hdf5/group_builder.h"
#include "hdf5/output_file.h"
#include "store/format.h"
#include "store/root_attributes.h"
#include "text/scalars.h"
#include "text/summary_unit.h"

namespace fissure {

namespace {

constexpr std::size_t most_block_rows = 1024;
constexpr std::size_t most_block_values = std::size_t{1} << 16;  // of a curve: 512 KiB, and a chunk's size

/// The column of a dataset, written a block of rows at a time.
template <typename Value>
class Block {
 public:
  Block(GrowingDataset data, std::size_t block_rows, std::size_t width = 1)
      : data_(std::move(data)), block_rows_(block_rows), width_(width) {}

  void add(const Value* row) {
    values_.insert(values_.end(), row, row + width_);
    if (++rows_ == block_rows_) write();
  }
  void add(const Value& value) { add(&value); }
  std::size_t width() const { return width_; }

  void write() {
    if (rows_ == 0) return;
    if constexpr (std::is_same_v<Value, std::string>) {
      std::vector<const char*> pointers;
      for (const std::string& text : values_) pointers.push_back(text.c_str());
      data_.append(pointers.data(), rows_);
    } else {
      data_.append(values_.data(), rows_);
    }
    values_.clear();
    rows_ = 0;
  }

 private:
  GrowingDataset data_;
  std::size_t block_rows_;
  std::size_t width_;
  std::size_t rows_ = 0;
  std::vector<Value> values_;
};

using Numbers = Block<double>;
using Counts = Block<std::int64_t>;
using Texts = Block<std::string>;

const std::string timing_prefix = "timing/";

bool isTiming(const SweepMetric& metric) {
  return metric.name.starts_with(timing_prefix);
}

std::string inWords(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// The file itself has the last word before it gets its name.
void verify(const std::filesystem::path& path, std::size_t runs) {
  try {
    if (SweepTable(path).runs() == runs) return;
  } catch (const InputError& error) {
    throw RunError(std::string("not all of it was written: ") + error.what());
  }
  throw RunError("not all of it was written");
}

double numberOf(const std::string& text, const SweepAxisColumn& axis) {
  const std::optional<double> number = toReal(text);
  if (!number)
    throw std::logic_error(fmt::format("axis {} is numeric, but has the value {}", axis.name, text));
  return *number;
}

/// The columns of the root, in the order of their creation. Names beside the data say which of them are
/// coordinates of a run, as CF has it.
class Columns {
 public:
  Columns(GroupBuilder& group, const SweepTableLayout& layout)
      : group_(group),
        block_rows_(std::clamp<std::size_t>(layout.runs, 1, most_block_rows)),
        coordinates_("point pipeline repeat") {
    for (const SweepAxisColumn& axis : layout.axes) coordinates_ += " " + axis.name;
  }

  Counts counts(const std::string& name, const std::string& long_name) {
    return {group_.addPacked(spec(name, "1", long_name, ValueType::count)), block_rows_};
  }
  Texts texts(const std::string& name, const std::string& long_name) {
    return {group_.addTexts(spec(name, "1", long_name, ValueType::count)), block_rows_};
  }
  Numbers numbers(const std::string& name, const std::string& long_name) {
    return {group_.addPacked(spec(name, summaryUnit(name), long_name, ValueType::real)), block_rows_};
  }
  Numbers curve(const CurveQuantity& curve, const SweepTableLayout& layout) {
    const std::size_t width = layout.width(curve);
    const std::size_t rows = std::clamp<std::size_t>(most_block_values / width, 1, block_rows_);
    DatasetSpec made{curve.name, curve.units, curve.long_name, ValueType::real, {{"run", rows, true}}};
    if (curve.per_law) made.dimensions.push_back({"law", layout.laws.size()});
    made.dimensions.push_back({"curve_time", layout.curve_time_s.size()});
    return {group_.addPacked(made), rows, width};
  }

  void setText(const std::string& column, const char* attribute, const std::string& text) {
    h5::setAttribute(h5::openDataset(group_.id(), column), attribute, text);
  }
  void setCoordinates(const std::string& column) { setText(column, "coordinates", coordinates_); }

 private:
  DatasetSpec spec(const std::string& name, const std::string& units, const std::string& long_name,
                   ValueType type) const {
    return {name, units, long_name, type, {{"run", block_rows_, true}}};
  }

  GroupBuilder& group_;
  std::size_t block_rows_;
  std::string coordinates_;
};

}  // namespace

struct SweepTableWriter::State {
  State(const std::filesystem::path& path, const SweepTableLayout& layout) try
      : path_(path), layout_(layout), replacement_(path) {
  } catch (const RunError& error) {
    throw RunError(path.string() + ": " + error.what());
  }
  void begin();
  void add(const SweepRun& run);
  void finish(bool complete);
  /// Does `work`; its RunError says which file, and not what HDF5 stumbled on after a failed write.
  template <typename Work>
  void named(const Work& work);

 private:
  void makeColumns();
  void makeAxis(Columns& columns, const SweepAxisColumn& axis);
  void makeCurves(GroupBuilder& root, Columns& columns);
  void makeTiming();
  void writeProvenance() const;

  std::filesystem::path path_;
  SweepTableLayout layout_;
  ReplacementFile replacement_;
  std::size_t rows_ = 0;
  std::vector<Counts> counts_;  // run, point, repeat, and run of timing
  std::vector<Texts> texts_;    // pipeline, axes that are not numeric, status, status_detail, file
  std::vector<Numbers> axes_;   // the numeric ones
  std::vector<Numbers> metrics_;
  std::vector<Numbers> timings_;
  std::vector<Numbers> curves_;
};

template <typename Work>
void SweepTableWriter::State::named(const Work& work) {
  const auto say = [this](const std::string& reason) { return RunError(path_.string() + ": " + reason); };
  try {
    work();
  } catch (const RunError& error) {
    throw say(replacement_.file().writeFailure().value_or(error.what()));
  }
  if (const auto failure = replacement_.file().writeFailure()) throw say(*failure);
}

void SweepTableWriter::State::begin() {
  describeRoot(replacement_.file(), layout_.title, layout_.description, layout_.provenance,
               layout_.sweep_source, sweep_format);
  h5::setAttribute(replacement_.file(), "design", layout_.design);
  makeColumns();
  makeTiming();
  writeProvenance();
}

void SweepTableWriter::State::makeColumns() {
  GroupBuilder root(h5::openGroup(replacement_.file(), "/"));
  Columns columns(root, layout_);
  counts_.push_back(columns.counts("run", "number of each run"));
  counts_.push_back(columns.counts("point", "number of the point of the sweep"));
  texts_.push_back(columns.texts("pipeline", "entry of the scenario's pipelines"));
  counts_.push_back(columns.counts("repeat", "number of the repeat"));
  for (const SweepAxisColumn& axis : layout_.axes) makeAxis(columns, axis);
  texts_.push_back(columns.texts("status", "how the run ended"));
  texts_.push_back(columns.texts("status_detail", "when and where it ended early"));
  texts_.push_back(columns.texts("file", "result file, from the sweep's folder on"));
  for (const char* name : {"status", "status_detail", "file"}) columns.setCoordinates(name);
  for (const SweepMetric& metric : layout_.metrics) {
    if (isTiming(metric)) continue;
    metrics_.push_back(columns.numbers(metric.name, inWords(metric.name)));
    columns.setCoordinates(metric.name);
  }
  if (!layout_.curve_time_s.empty()) makeCurves(root, columns);
}

void SweepTableWriter::State::makeAxis(Columns& columns, const SweepAxisColumn& axis) {
  if (axis.numeric)
    axes_.push_back(columns.numbers(axis.name, axis.path));
  else
    texts_.push_back(columns.texts(axis.name, axis.path));
  columns.setText(axis.name, "path", axis.path);
}

void SweepTableWriter::State::makeCurves(GroupBuilder& root, Columns& columns) {
  const Dimension time{"curve_time", layout_.curve_time_s.size()};
  if (!layout_.laws.empty()) root.addLabels("law", layout_.laws);
  root.addFixed({"curve_time", "s", "time of each value of a curve", ValueType::real, {time}},
                layout_.curve_time_s);
  if (!layout_.measured_N.empty())
    root.addFixed({"measured", "N", "measured force that forces are compared with", ValueType::real, {time}},
                  layout_.measured_N);
  for (const CurveQuantity& curve : layout_.curves) {
    if (layout_.width(curve) == 0) continue;
    curves_.push_back(columns.curve(curve, layout_));
    columns.setCoordinates(curve.name);
  }
}

// Apart, because no two sweeps agree on it.
void SweepTableWriter::State::makeTiming() {
  if (std::none_of(layout_.metrics.begin(), layout_.metrics.end(), isTiming)) return;
  GroupBuilder group(replacement_.file(), "timing");
  Columns columns(group, layout_);
  counts_.push_back(columns.counts("run", "number of each run"));
  for (const SweepMetric& metric : layout_.metrics) {
    if (!isTiming(metric)) continue;
    const std::string name = metric.name.substr(timing_prefix.size());
    timings_.push_back(columns.numbers(name, inWords(name)));
  }
}

void SweepTableWriter::State::writeProvenance() const {
  const h5::Id group = h5::createGroup(replacement_.file(), "provenance");
  for (const auto& [name, value] : layout_.provenance) h5::setAttribute(group, name, value);
  h5::writeText(group, "sweep_source", layout_.sweep_source);
}

void SweepTableWriter::State::add(const SweepRun& run) {
  const auto width = [](std::size_t sum, const Numbers& curve) { return sum + curve.width(); };
  if (run.values.size() != layout_.axes.size() || run.metrics.size() != layout_.metrics.size() ||
      run.curves.size() != std::accumulate(curves_.begin(), curves_.end(), std::size_t{0}, width))
    throw std::logic_error("a row does not fit its sweep's table");
  const std::array<std::int64_t, 4> counts = {static_cast<std::int64_t>(rows_), run.point, run.repeat,
                                              static_cast<std::int64_t>(rows_)};
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i].add(counts[i]);
  auto number = axes_.begin();
  auto text = texts_.begin();
  (text++)->add(run.pipeline);
  for (std::size_t i = 0; i < run.values.size(); ++i) {
    if (layout_.axes[i].numeric)
      (number++)->add(numberOf(run.values[i], layout_.axes[i]));
    else
      (text++)->add(run.values[i]);
  }
  for (const std::string& last : {nameOf(run.end), run.detail, run.file}) (text++)->add(last);
  auto metric = metrics_.begin();
  auto timing = timings_.begin();
  for (std::size_t i = 0; i < run.metrics.size(); ++i)
    (isTiming(layout_.metrics[i]) ? timing++ : metric++)->add(run.metrics[i]);
  const double* values = run.curves.data();
  for (Numbers& curve : curves_) {
    curve.add(values);
    values += curve.width();
  }
  ++rows_;
}

void SweepTableWriter::State::finish(bool complete) {
  if (rows_ != layout_.runs) throw std::logic_error("a sweep's table lacks rows");
  const auto writeAll = [](auto& columns) {
    for (auto& column : columns) column.write();
    columns.clear();
  };
  writeAll(counts_);
  writeAll(texts_);
  for (std::vector<Numbers>* columns : {&axes_, &metrics_, &timings_, &curves_}) writeAll(*columns);
  attachScales(h5::openGroup(replacement_.file(), "/"));
  h5::setAttribute(replacement_.file(), "complete", static_cast<std::int32_t>(complete));
  replacement_.close();
  verify(replacement_.temporaryPath(), rows_);
  replacement_.commit();
}

SweepTableWriter::SweepTableWriter(const std::filesystem::path& path, const SweepTableLayout& layout)
    : state_(std::make_unique<State>(path, layout)) {
  state_->named([&] { state_->begin(); });
}

SweepTableWriter::SweepTableWriter(SweepTableWriter&&) noexcept = default;
SweepTableWriter::~SweepTableWriter() = default;

void SweepTableWriter::append(const SweepRun& run) {
  state_->named([&] { state_->add(run); });
}

void SweepTableWriter::finish(bool complete) {
  state_->named([&] { state_->finish(complete); });
}

}  // namespace fissure
