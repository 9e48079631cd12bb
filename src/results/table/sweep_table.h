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
  std::string name;  ///< name of the variable (sweep_names.h), which ends with its unit
  std::string path;  ///< key path in the scenario
  bool numeric = true;
};

/// A number from each run's summary. Its name ends with its unit; a name that begins with "timing/" is that
/// of a variable in this group.
struct SweepMetric {
  std::string name;
};

/// The description of a sweep's table, without its rows. Names of axes, metrics, curves and fixed columns
/// must all be different.
struct SweepTableLayout {
  std::string title;
  std::string description;
  /// "grid", "sobol" ...
  std::string design;
  std::vector<SweepAxisColumn> axes;
  /// Names of the base scenario's laws; without laws there are no curves per law.
  std::vector<std::string> laws;
  std::vector<SweepMetric> metrics;
  std::vector<CurveQuantity> curves;  ///< curves of each run over `curve_time`
  std::vector<double> curve_time_s;   ///< empty: no curves are kept
  std::vector<double> measured_N;     ///< [curve_time] measured force to which laws are fitted; empty: none
  std::size_t runs = 0;               ///< number of rows
  std::string sweep_source;           ///< the sweep file, verbatim
  Provenance provenance;

  /// Number of values of a curve in one row: laws x times, or times.
  std::size_t width(const CurveQuantity& curve) const;
};

/// One row of a sweep's table. Missing numbers are NaN.
struct SweepRun {
  long long point = 0;
  long long repeat = 0;
  std::string pipeline;
  RunEnd end = RunEnd::missing;
  std::string detail;
  /// Path of the result below the sweep's folder; "" where none is kept.
  std::string file;
  std::vector<std::string> values;  ///< one per axis, as YAML
  std::vector<double> metrics;      ///< one per metric
  std::vector<double> curves;       ///< all curves, one after the other, each with time as the fastest index
};

/// Whether an HDF5 file has the format of a sweep's table. Throws InputError about a file that is missing,
/// damaged or no HDF5 file.
bool isSweepTable(const std::filesystem::path& path);

/// Reads a sweep's table, sweep.h5, with one row per run. All functions throw InputError about the file when
/// it is missing, damaged, no sweep's table or of a newer format_version. HDF5 may crash on a damaged file:
/// try to read it in a child process first.
class SweepTable {
 public:
  explicit SweepTable(const std::filesystem::path& path);
  SweepTable(SweepTable&&) noexcept;
  ~SweepTable();

  const SweepTableLayout& layout() const { return layout_; }
  std::size_t runs() const { return layout_.runs; }
  /// Whether no run is missing.
  bool complete() const { return complete_; }

  /// Rows `first` to `first + count - 1` of a numeric column: "point", "repeat", a numeric axis or a metric.
  std::vector<double> numbers(const std::string& column, std::size_t first, std::size_t count) const;
  std::vector<double> numbers(const std::string& column) const { return numbers(column, 0, runs()); }
  /// The same for a column of texts: "pipeline", "status", "status_detail", "file" or an axis that is not
  /// numeric.
  std::vector<std::string> texts(const std::string& column, std::size_t first, std::size_t count) const;
  std::vector<std::string> texts(const std::string& column) const { return texts(column, 0, runs()); }
  /// The column "status": how each run ended. An unknown name counts as damage.
  std::vector<RunEnd> ends() const;
  /// Rows of a curve, with layout().width(curve) values each.
  std::vector<double> curves(const CurveQuantity& curve, std::size_t first, std::size_t count) const;

 private:
  struct Opened;
  std::filesystem::path path_;
  std::unique_ptr<Opened> opened_;
  SweepTableLayout layout_;
  bool complete_ = false;
};

}  // namespace fissure
