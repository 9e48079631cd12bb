#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/run_status.h"

namespace fissure {

/// What one simulation of a sweep gave, a row a set of force laws.
struct TaskNumbers {
  std::vector<std::string> names;  ///< of the summary's numbers, without timing
  std::size_t rows = 0;
  std::vector<double> values;                ///< row by row
  std::vector<double> curves;                ///< row by row, all of a row one after the other
  std::map<std::string, std::string> texts;  ///< of the summary: the same in all rows
};

/// One record of a journal.
struct TaskRecord {
  std::string task;  ///< SweepTask::id
  RunStatus status;
  /// encodeNumbers() of what the simulation gave; empty when it gave nothing. Equal bytes are equal numbers.
  std::string numbers;
  std::map<std::string, double> timing;  ///< "timing/...": may differ between two runs
  std::string file;                      ///< of the result, from the sweep's folder on; "" where none is kept
  long long file_bytes = 0;
  long long file_time = 0;  ///< when it was last changed, as the file system counts
  long long recorded_s =
      0;  ///< when it was written, seconds since 1970: of two failures the later one counts

  /// Whether the simulation came to its end: the same task would give the same numbers again.
  bool finished() const { return status.end == RunEnd::ok || status.end == RunEnd::non_finite; }
};

/// Where in the bytes of encodeNumbers() what lies.
struct NumbersHead {
  std::vector<std::string> names;
  std::map<std::string, std::string> texts;
  std::size_t rows = 0;
  std::size_t curve_values = 0;  ///< of one row
  std::size_t values_at = 0;     ///< of the values of all rows, 8 bytes each
  std::size_t curves_at = 0;     ///< of the curves of all rows
};

std::string encodeNumbers(const TaskNumbers& numbers);
/// Throws RunError on bytes that encodeNumbers() did not make.
TaskNumbers decodeNumbers(const std::string& bytes);

/// Of the beginning of such bytes, as much as is there; throws RunError when it is too little.
NumbersHead decodeNumbersHead(const std::string& bytes);
/// Doubles as they lie in such bytes.
std::vector<double> numbersIn(const std::string& bytes);

std::string encodeRecord(const TaskRecord& record);
/// Throws RunError on bytes that encodeRecord() did not make.
TaskRecord decodeRecord(const std::string& bytes);
/// Of the beginning of such bytes: all but the numbers, and where these begin.
std::pair<TaskRecord, std::size_t> decodeRecordHead(const std::string& bytes);

}  // namespace fissure
