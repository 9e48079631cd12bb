#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/run_status.h"

namespace fissure {

/// The numbers from one simulation of a sweep, one row per set of force laws.
struct TaskNumbers {
  std::vector<std::string> names;  ///< names of the summary's numbers, without timing
  std::size_t rows = 0;
  std::vector<double> values;                ///< row by row
  std::vector<double> curves;                ///< row by row, in a row all curves one after the other
  std::map<std::string, std::string> texts;  ///< texts of the summary, the same in all rows
};

/// One record of a journal.
struct TaskRecord {
  std::string task;  ///< SweepTask::id
  RunStatus status;
  /// encodeNumbers() of the simulation's numbers; empty when there are none. Equal bytes are equal numbers.
  std::string numbers;
  /// "timing/...": may differ between two runs.
  std::map<std::string, double> timing;
  /// Path of the result below the sweep's folder; "" where none is kept.
  std::string file;
  long long file_bytes = 0;
  long long file_time = 0;  ///< modification time of that file, in units of the file system
  /// Time of this record, seconds since 1970: of two failures the later one counts.
  long long recorded_s = 0;

  /// Whether the simulation ended by itself, so that the same task would give the same numbers again.
  bool finished() const { return status.end == RunEnd::ok || status.end == RunEnd::non_finite; }
};

/// The layout of the bytes of encodeNumbers().
struct NumbersHead {
  std::vector<std::string> names;
  std::map<std::string, std::string> texts;
  std::size_t rows = 0;
  std::size_t curve_values = 0;  ///< number of curve values in one row
  std::size_t values_at = 0;     ///< offset of the values of all rows, 8 bytes each
  std::size_t curves_at = 0;     ///< offset of the curves of all rows
};

std::string encodeNumbers(const TaskNumbers& numbers);
/// Throws RunError on bytes that encodeNumbers() did not make.
TaskNumbers decodeNumbers(const std::string& bytes);

/// Reads the layout from the beginning of such bytes. Throws RunError when they are too few.
NumbersHead decodeNumbersHead(const std::string& bytes);
/// The doubles in a piece of such bytes.
std::vector<double> numbersIn(const std::string& bytes);

std::string encodeRecord(const TaskRecord& record);
/// Throws RunError on bytes that encodeRecord() did not make.
TaskRecord decodeRecord(const std::string& bytes);
/// Reads the beginning of such bytes: the record without its numbers, and the offset of these.
std::pair<TaskRecord, std::size_t> decodeRecordHead(const std::string& bytes);

}  // namespace fissure
