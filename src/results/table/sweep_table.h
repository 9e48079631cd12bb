#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/record.h"
#include "base/run_status.h"
#include "store/result_file.h"

namespace fissure {

/// The column of one axis of a sweep.
struct SweepAxisColumn {
  std::string name;  ///< of the variable (sweep_names.h); its unit is that of its ending
  std::string path;  ///< of the scenario
  bool numeric = true;
};

/// A number of each run's summary; the name carries the unit, and one that begins with "timing/" lies in that
/// group.
struct SweepMetric {
  std::string name;
};

/// What a sweep's table holds beside its rows. Names of axes, metrics and curves differ from each other and
/// from those of the fixed columns.
struct SweepTableLayout {
  std::string title;
  std::string description;
  std::string design;  ///< "grid", "sobol" ...
  std::vector<SweepAxisColumn> axes;
  std::vector<std::string> laws;  ///< of the base scenario; curves per law are left out where there is none
  std::vector<SweepMetric> metrics;
  std::vector<CurveQuantity> curves;  ///< of each run over `curve_time`
  std::vector<double> curve_time_s;   ///< empty: no curves are kept
  std::vector<double> measured_N;     ///< one a curve_time_s, what forces are fitted to; empty: nothing
  std::size_t runs = 0;               ///< rows
  std::string sweep_source;           ///< the sweep file, verbatim
  Provenance provenance;

  /// Values of one row of a curve: laws x times, or times.
  std::size_t width(const CurveQuantity& curve) const;
};

/// One row. Missing numbers are NaN.
struct SweepRun {
  long long point = 0;
  long long repeat = 0;
  std::string pipeline;
  RunEnd end = RunEnd::missing;
  std::string detail;
  std::string file;                 ///< of the result, from the sweep's folder on; "" where none is kept
  std::vector<std::string> values;  ///< YAML, one an axis
  std::vector<double> metrics;      ///< one a metric
  std::vector<double> curves;       ///< all, one after the other, each with the time fastest
};

/// Whether an HDF5 file says that it is a sweep's table. Throws InputError about a file that is missing,
/// damaged or no HDF5 file.
bool isSweepTable(const std::filesystem::path& path);

/// A sweep's table, sweep.h5, one row a run. Everything here throws InputError about the file when it is
/// missing, damaged, no sweep's table or of a newer format_version. Whether HDF5 crashes on it is not known
/// here.
class SweepTable {
 public:
  explicit SweepTable(const std::filesystem::path& path);
  SweepTable(SweepTable&&) noexcept;
  ~SweepTable();

  const SweepTableLayout& layout() const { return layout_; }
  std::size_t runs() const { return layout_.runs; }
  /// No run is missing.
  bool complete() const { return complete_; }

  /// Rows `first` to `first + count - 1` of a column of numbers: "point", "repeat", a numeric axis, a metric.
  std::vector<double> numbers(const std::string& column, std::size_t first, std::size_t count) const;
  std::vector<double> numbers(const std::string& column) const { return numbers(column, 0, runs()); }
  /// The same of texts: "pipeline", "status", "status_detail", "file", an axis that is not numeric.
  std::vector<std::string> texts(const std::string& column, std::size_t first, std::size_t count) const;
  std::vector<std::string> texts(const std::string& column) const { return texts(column, 0, runs()); }
  /// How each run ended: the column "status". A name that RunEnd does not have is that of a damaged table.
  std::vector<RunEnd> ends() const;
  /// Rows of a curve as of a column, layout().width() values a row.
  std::vector<double> curves(const CurveQuantity& curve, std::size_t first, std::size_t count) const;

 private:
  struct Opened;
  std::filesystem::path path_;
  std::unique_ptr<Opened> opened_;
  SweepTableLayout layout_;
  bool complete_ = false;
};

}  // namespace fissure
