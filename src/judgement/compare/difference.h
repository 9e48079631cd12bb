#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fissure {

/// The index of a value in a series: its row (a step, a snapshot), and its column in the row.
struct ValueIndex {
  std::size_t row = 0;
  std::size_t column = 0;

  bool operator==(const ValueIndex&) const = default;
};

/// The difference of two series A and B in maximum norms, so that a single outlier is never hidden.
struct Difference {
  double largest = 0;  ///< max |A - B| over the numbers; infinite where only one of two is infinite
  std::optional<ValueIndex> worst;  ///< place of the largest difference; no value when no number differs
  std::optional<ValueIndex> first;  ///< the first value that differs, NaN too
  std::size_t count = 0;            ///< number of values that differ
  std::size_t rows = 0;             ///< number of rows compared
  double largest_a = 0;             ///< max |A|
  double largest_b = 0;             ///< max |B|
  /// First NaN of A that is not allowed: any NaN, or, where NaN may mean "missing", one that only A has.
  std::optional<ValueIndex> nan_a;
  std::optional<ValueIndex> nan_b;
};

/// The rules by which two values differ.
struct DifferenceRules {
  bool exact = false;  ///< bit for bit: 0 and -0 differ
  /// NaN means "missing", and two of them are the same.
  bool may_be_missing = false;
};

/// Compares two series block by block.
class DifferenceMeter {
 public:
  /// `columns`: number of values per row.
  DifferenceMeter(std::size_t columns, const DifferenceRules& rules) : columns_(columns), rules_(rules) {}

  /// Takes the next rows of both series, the same number of each.
  void add(std::span<const double> a, std::span<const double> b);
  const Difference& result() const { return result_; }
  /// The first row with a difference above `allowed` or with a NaN that is not allowed; no value when there
  /// is none.
  std::optional<std::size_t> firstRowBeyond(double allowed) const;

 private:
  void compare(double a, double b, const ValueIndex& place, double& of_row);

  std::size_t columns_;
  DifferenceRules rules_;
  Difference result_;
  std::vector<double> of_row_;  ///< [row] max |A - B|
};

/// A shift in time of A against B.
struct TimeShift {
  long long rows = 0;    ///< delay of A in rows of A
  double remaining = 0;  ///< max |A - B| after the shift, over the rows of B that have a partner
};

/// The shift by at most `most_rows` rows of A that leaves the smallest difference; among equal ones the
/// shortest, and of two opposite ones that with the larger delay. `partners`: [row of B] the row of A with
/// which it is compared at shift zero, ascending. At most half of the rows of B may lose their partner. The
/// difference between NaN and a number is infinite.
TimeShift bestShift(std::span<const double> a, std::span<const double> b,
                    std::span<const std::size_t> partners, std::size_t columns, std::size_t most_rows);

}  // namespace fissure
