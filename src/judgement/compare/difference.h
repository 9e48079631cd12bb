#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fissure {

/// A value of a series: its row (a step, a snapshot), and its place in the row.
struct ValueIndex {
  std::size_t row = 0;
  std::size_t column = 0;

  bool operator==(const ValueIndex&) const = default;
};

/// How two series A and B differ, as maximum norms: one value that flew off is never hidden by others.
struct Difference {
  double largest = 0;               ///< max |A - B| over the numbers; infinite where one of two is
  std::optional<ValueIndex> worst;  ///< of it; no value when no number differs
  std::optional<ValueIndex> first;  ///< the first value that differs, NaN too
  std::size_t count = 0;            ///< values that differ
  std::size_t rows = 0;             ///< compared
  double largest_a = 0;             ///< max |A|
  double largest_b = 0;             ///< max |B|
  std::optional<ValueIndex> nan_a;  ///< first NaN of A that is not allowed: any, or one that only A has
  std::optional<ValueIndex> nan_b;
};

/// What counts as a difference.
struct DifferenceRules {
  bool exact = false;           ///< bit for bit: 0 and -0 differ
  bool may_be_missing = false;  ///< NaN means "missing", and two of them are the same
};

/// Compares two series block by block.
class DifferenceMeter {
 public:
  /// `columns`: values in a row.
  DifferenceMeter(std::size_t columns, const DifferenceRules& rules) : columns_(columns), rules_(rules) {}

  /// The next rows of both, of equal number.
  void add(std::span<const double> a, std::span<const double> b);
  const Difference& result() const { return result_; }
  /// The first row whose difference is beyond `allowed`, as one with a NaN is; no value when there is none.
  std::optional<std::size_t> firstRowBeyond(double allowed) const;

 private:
  void compare(double a, double b, const ValueIndex& place, double& of_row);

  std::size_t columns_;
  DifferenceRules rules_;
  Difference result_;
  std::vector<double> of_row_;  ///< max |A - B|
};

/// A shifted in time against B.
struct TimeShift {
  long long rows = 0;    ///< A is late by so many of its rows
  double remaining = 0;  ///< max |A - B| then, over the rows of B that have a partner
};

/// The shift by at most `most_rows` of A that leaves the least difference; of equals the shortest, and of two
/// opposite ones the later. `partners`: for each row of B the row of A that it is compared with at shift
/// zero, ascending. At most half of B may lose its partner. NaN against a number is infinitely far.
TimeShift bestShift(std::span<const double> a, std::span<const double> b,
                    std::span<const std::size_t> partners, std::size_t columns, std::size_t most_rows);

}  // namespace fissure
