#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "hdf5/h5.h"
#include "hdf5/output_file.h"

namespace fissure {

/// A part file open for reading, as assembly needs it.
class PartReader {
 public:
  /// Opens the part and checks that it is one and holds the group of `pipeline`, readable down to the last
  /// dataset. Throws RunError.
  PartReader(const std::filesystem::path& path, const std::string& pipeline);

  /// What the worker says of itself: the texts of the part's /provenance.
  std::vector<std::pair<std::string, std::string>> provenance() const;

  /// Of the rows of the record that count as written.
  std::vector<double> times_s() const;
  /// Of the whole run; 0: unknown.
  long long expectedRows() const { return h5::integerAttribute(file_, "expected_rows", 0); }

  /// Copies datasets, subgroups and their attributes into `group`, but not the attributes of the pipeline's
  /// group itself, and cuts what a killed worker left unfinished: every growing axis ends at its last written
  /// time.
  void copyTo(hid_t group, const h5::OutputFile& file) const;

 private:
  h5::Id file_;
  h5::Id group_;
};

}  // namespace fissure
