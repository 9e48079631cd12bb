#pragma once

#include <filesystem>
#include <memory>

#include "table/sweep_table.h"

namespace fissure {

/// Writes a sweep's table row by row, in memory that does not depend on the number of rows. The same rows
/// give the same data. finish() replaces `path` by the complete table; a writer that is destroyed before
/// leaves no file behind.
class SweepTableWriter {
 public:
  /// All functions throw RunError about `path` when writing fails (a full disk), and std::logic_error when
  /// names of the layout are not unique or rows do not fit it.
  SweepTableWriter(const std::filesystem::path& path, const SweepTableLayout& layout);
  SweepTableWriter(SweepTableWriter&&) noexcept;
  ~SweepTableWriter();

  /// Appends a row. Values of a numeric axis must be numbers.
  void append(const SweepRun& run);
  /// Completes the table after all `layout.runs` rows. `complete`: whether no run is missing.
  void finish(bool complete);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fissure
