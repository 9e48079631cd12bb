#pragma once

#include <cstddef>
#include <string>

namespace fissure {

/// A recorded log, read sample by sample as numbers in named columns.
class LogTable {
 public:
  virtual ~LogTable() = default;

  /// Index of a named column. Throws InputError, which lists the known names, when the name is missing or
  /// stands there twice.
  virtual std::size_t column(const std::string& name) const = 0;
  /// Moves to the next sample; returns false after the last one. Throws InputError when the sample cannot be
  /// read.
  virtual bool next() = 0;
  /// The value of this sample in a column; NaN where the log has none. Throws InputError with the line number
  /// when the cell is no number.
  virtual double number(std::size_t column) const = 0;
  /// Line number of this sample in the file, from 1.
  virtual int line() const = 0;
  virtual const std::string& fileName() const = 0;
};

}  // namespace fissure
