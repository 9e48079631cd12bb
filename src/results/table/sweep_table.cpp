#include "table/sweep_table.h"

#include <algorithm>

#include "base/error.h"
#include "hdf5/axes.h"
#include "store/format.h"
#include "store/stored_file.h"
#include "table/sweep_names.h"

namespace fissure {

namespace {

const StoredFormat format = {{sweep_format}, "a fissure sweep"};

/// Rows of a dataset whose first axis is the runs.
struct Rows {
  Rows(hid_t file, const std::string& name, std::size_t first, std::size_t count)
      : dataset(h5::openDataset(file, name)),
        size(h5::shapeOf(dataset)),
        from(H5Dget_space(dataset), H5Sclose, "cannot read", name) {
    h5::requireStored(dataset);
    if (size.empty() || first + count > size.front()) throw RunError(name + " has fewer rows than the runs");
    std::vector<hsize_t> start(size.size(), 0);
    start.front() = first;
    size.front() = count;
    h5::check(H5Sselect_hyperslab(from, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
              "cannot read", name);
    to = h5::Id(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose,
                "cannot read", name);
    for (const hsize_t length : size) values *= length;
  }

  h5::Id dataset;
  std::vector<hsize_t> size;
  h5::Id from;
  h5::Id to;
  std::size_t values = 1;
};

std::vector<double> readNumbers(hid_t file, const std::string& name, std::size_t first, std::size_t count) {
  const Rows rows(file, name, first, count);
  std::vector<double> numbers(rows.values);
  if (numbers.empty()) return numbers;
  h5::check(H5Dread(rows.dataset, H5T_NATIVE_DOUBLE, rows.to, rows.from, H5P_DEFAULT, numbers.data()),
            "cannot read", name);
  return numbers;
}

std::vector<std::string> readTexts(hid_t file, const std::string& name, std::size_t first,
                                   std::size_t count) {
  const Rows rows(file, name, first, count);
  if (!h5::isText(rows.dataset)) throw RunError(name + " is no text");
  const h5::Id type = h5::textType();
  std::vector<char*> pointers(rows.values, nullptr);
  std::vector<std::string> texts;
  if (pointers.empty()) return texts;
  h5::check(H5Dread(rows.dataset, type, rows.to, rows.from, h5::transferOf(type), pointers.data()),
            "cannot read", name);
  for (const char* text : pointers) texts.emplace_back(text ? text : "");
  h5::check(H5Dvlen_reclaim(type, rows.to, H5P_DEFAULT, pointers.data()), "cannot read", name);
  return texts;
}

std::size_t lengthOf(hid_t file, const std::string& name) {
  const std::vector<hsize_t> shape = h5::shapeOf(h5::openDataset(file, name));
  if (shape.size() != 1) throw RunError(name + " is no list");
  return shape.front();
}

std::vector<double> readAll(hid_t file, const std::string& name) {
  return readNumbers(file, name, 0, lengthOf(file, name));
}

void readColumn(hid_t file, const std::string& name, SweepTableLayout& layout) {
  if (fixedSweepColumns().contains(name)) return;
  const h5::Id dataset = h5::openDataset(file, name);
  const std::vector<std::string> axes = h5::axisNames(dataset, name);
  if (axes.empty() || axes.front() != "run") return;
  const std::string path = h5::textAttribute(dataset, "path");
  if (!path.empty()) {
    layout.axes.push_back({name, path, !h5::isText(dataset)});
  } else if (axes.back() == "curve_time") {
    layout.curves.push_back({name, h5::textAttribute(dataset, "units"),
                             h5::textAttribute(dataset, "long_name"), axes.size() == 3});
  } else if (axes.size() == 1 && !h5::isText(dataset)) {
    layout.metrics.push_back({name});
  }
}

void readProvenance(hid_t file, SweepTableLayout& layout) {
  if (!h5::exists(file, "provenance")) return;
  const h5::Id group = h5::openGroup(file, "provenance");
  for (const std::string& name : h5::attributeNames(group))
    layout.provenance.emplace_back(name, h5::textAttribute(group, name));
  for (const std::string& text : h5::readTexts(h5::openDataset(group, "sweep_source")))
    layout.sweep_source = text;
}

SweepTableLayout readLayout(hid_t file) {
  SweepTableLayout layout;
  layout.title = h5::textAttribute(file, "title");
  layout.description = h5::textAttribute(file, "summary");
  layout.design = h5::textAttribute(file, "design");
  layout.runs = lengthOf(file, "run");
  for (const std::string& name : h5::childNames(file)) {
    if (!h5::isGroup(h5::openObject(file, name))) readColumn(file, name, layout);
  }
  if (h5::exists(file, "timing")) {
    for (const std::string& name : h5::childNames(h5::openGroup(file, "timing")))
      if (name != "run") layout.metrics.push_back({"timing/" + name});
  }
  if (h5::exists(file, "law")) layout.laws = h5::readTexts(h5::openDataset(file, "law"));
  if (h5::exists(file, "curve_time")) layout.curve_time_s = readAll(file, "curve_time");
  if (h5::exists(file, "measured")) layout.measured_N = readAll(file, "measured");
  if (!layout.measured_N.empty() && layout.measured_N.size() != layout.curve_time_s.size())
    throw RunError("measured has another length than curve_time");
  readProvenance(file, layout);
  return layout;
}

}  // namespace

struct SweepTable::Opened {
  h5::Id file;
};

std::size_t SweepTableLayout::width(const CurveQuantity& curve) const {
  return curve_time_s.size() * (curve.per_law ? laws.size() : 1);
}

bool isSweepTable(const std::filesystem::path& path) {
  std::string name;
  readStoredFile(path, {{}, "a fissure result"},
                 [&](const h5::Id& file) { name = h5::textAttribute(file, "format"); });
  return name == sweep_format;
}

SweepTable::SweepTable(const std::filesystem::path& path) : path_(path), opened_(std::make_unique<Opened>()) {
  readStoredFile(path, format, [&](h5::Id file) {
    layout_ = readLayout(file);
    complete_ = h5::integerAttribute(file, "complete", 0) == 1;
    opened_->file = std::move(file);
  });
}

SweepTable::SweepTable(SweepTable&&) noexcept = default;
SweepTable::~SweepTable() = default;

std::vector<double> SweepTable::numbers(const std::string& column, std::size_t first, std::size_t count) const
    try {
  return readNumbers(opened_->file, column, first, count);
} catch (const RunError& error) {
  throw InputError(inFile(path_), error.what());
}

std::vector<std::string> SweepTable::texts(const std::string& column, std::size_t first,
                                           std::size_t count) const try {
  return readTexts(opened_->file, column, first, count);
} catch (const RunError& error) {
  throw InputError(inFile(path_), error.what());
}

std::vector<RunEnd> SweepTable::ends() const {
  const std::vector<std::string> names = texts("status");
  std::vector<RunEnd> ends;
  try {
    for (const std::string& name : names) ends.push_back(runEndNamed(name));
  } catch (const InputError& error) {
    throw InputError(inFile(path_), error.what());
  }
  return ends;
}

std::vector<double> SweepTable::curves(const CurveQuantity& curve, std::size_t first,
                                       std::size_t count) const {
  std::vector<double> values = numbers(curve.name, first, count);
  if (values.size() != count * layout_.width(curve))
    throw InputError(inFile(path_), curve.name + " has another shape than its axes");
  return values;
}

}  // namespace fissure
