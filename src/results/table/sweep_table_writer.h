#pragma once

#include <filesystem>
#include <memory>

#include "table/sweep_table.h"

namespace fissure {

/// Writes a sweep's table row by row, and takes as much memory for a hundred thousand rows as for a thousand.
/// The same rows give the same data. Under `path` stands what stood there before until finish() has put the
/// whole table in its place; a writer that is dropped before leaves nothing behind.
class SweepTableWriter {
 public:
  /// Everything here throws RunError about `path` (a full disk too), and std::logic_error when names of the
  /// layout clash or rows do not fit it.
  SweepTableWriter(const std::filesystem::path& path, const SweepTableLayout& layout);
  SweepTableWriter(SweepTableWriter&&) noexcept;
  ~SweepTableWriter();

  /// The next row. Values of a numeric axis must be numbers.
  void append(const SweepRun& run);
  /// After all `layout.runs` rows. `complete`: no run is missing.
  void finish(bool complete);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fissure
