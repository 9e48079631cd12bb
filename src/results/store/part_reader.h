#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "hdf5/h5.h"
#include "hdf5/output_file.h"

namespace fissure {

/// Reads a part file for the assembly of a result. Its functions throw RunError when the part is damaged.
class PartReader {
 public:
  /// Opens the file and checks that it is a part with the group of `pipeline` and that all datasets can be
  /// read. Throws RunError otherwise.
  PartReader(const std::filesystem::path& path, const std::string& pipeline);

  /// The texts of the part's /provenance, which the worker has written.
  std::vector<std::pair<std::string, std::string>> provenance() const;

  /// Times of the committed rows of the record.
  std::vector<double> times_s() const;
  /// Number of steps of the whole run; 0: unknown.
  long long expectedSteps() const { return h5::integerAttribute(file_, "expected_steps", 0); }
  /// Number of steps from one row of the record to the next.
  long long stepsPerRow() const { return h5::integerAttribute(file_, "steps_per_row", 1); }

  /// Copies datasets, subgroups and their attributes into `group` of `file`, without the attributes of the
  /// run's group itself. Rows that a killed worker left incomplete are dropped: every growing axis ends at
  /// its last committed time.
  void copyTo(hid_t group, const h5::OutputFile& file) const;

 private:
  h5::Id file_;
  h5::Id group_;
};

}  // namespace fissure
