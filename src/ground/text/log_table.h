#pragma once

#include <cstddef>
#include <string>

namespace fissure {

/// The samples of a log, one after the other, as numbers in columns.
class LogTable {
 public:
  virtual ~LogTable() = default;

  /// Index of a named column. Throws InputError, with the names that there are, when it is missing or there
  /// twice.
  virtual std::size_t column(const std::string& name) const = 0;
  /// Moves to the next sample; false after the last one. Throws InputError.
  virtual bool next() = 0;
  /// Of this sample; NaN where the log has none. Throws InputError with the line for what is no number.
  virtual double number(std::size_t column) const = 0;
  /// Of this sample, from 1.
  virtual int line() const = 0;
  virtual const std::string& fileName() const = 0;
};

}  // namespace fissure
