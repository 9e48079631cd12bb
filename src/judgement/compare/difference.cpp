#include "compare/difference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fissure {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

double distance(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double between = std::abs(a - b);
  return std::isnan(between) ? kInfinite : between;
}

/// A and B with the rows that belong together.
struct Paired {
  std::span<const double> a, b;
  std::span<const std::size_t> partners;
  std::size_t columns;

  /// max |A - B| at one shift; gives up at `enough`. Infinite where more than half of B has no partner.
  double differenceAt(long long shift, double enough) const {
    const auto rows_a = static_cast<long long>(a.size() / columns);
    double largest = 0;
    std::size_t alone = 0;
    for (std::size_t row = 0; row < partners.size() && largest < enough; ++row) {
      const long long partner = static_cast<long long>(partners[row]) + shift;
      if (partner < 0 || partner >= rows_a) {
        ++alone;
        continue;
      }
      const double* const of_a = &a[static_cast<std::size_t>(partner) * columns];
      const double* const of_b = &b[row * columns];
      for (std::size_t i = 0; i < columns; ++i) largest = std::max(largest, distance(of_a[i], of_b[i]));
    }
    return 2 * alone > partners.size() ? kInfinite : largest;
  }
};

}  // namespace

void DifferenceMeter::compare(double a, double b, const ValueIndex& place, double& of_row) {
  if (!std::isnan(a)) result_.largest_a = std::max(result_.largest_a, std::abs(a));
  if (!std::isnan(b)) result_.largest_b = std::max(result_.largest_b, std::abs(b));
  if (std::isnan(a) || std::isnan(b)) {
    if (rules_.may_be_missing && std::isnan(a) && std::isnan(b)) return;
    if (std::isnan(a) && !result_.nan_a) result_.nan_a = place;
    if (std::isnan(b) && !result_.nan_b) result_.nan_b = place;
    of_row = kInfinite;
    ++result_.count;
    if (!result_.first) result_.first = place;
    return;
  }
  if (rules_.exact ? sameBits(a, b) : a == b) {
    return;
  }
  ++result_.count;
  if (!result_.first) result_.first = place;
  const double between = distance(a, b);
  of_row = std::max(of_row, between);
  if (result_.worst && between <= result_.largest) return;
  result_.largest = between;
  result_.worst = place;
}

void DifferenceMeter::add(std::span<const double> a, std::span<const double> b) {
  if (columns_ == 0) return;
  for (std::size_t i = 0; i < a.size(); i += columns_) {
    double of_row = 0;
    for (std::size_t column = 0; column < columns_; ++column)
      compare(a[i + column], b[i + column], {result_.rows, column}, of_row);
    of_row_.push_back(of_row);
    ++result_.rows;
  }
}

std::optional<std::size_t> DifferenceMeter::firstRowBeyond(double allowed) const {
  const auto found = std::find_if(of_row_.begin(), of_row_.end(), [&](double row) { return row > allowed; });
  if (found == of_row_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - of_row_.begin());
}

TimeShift bestShift(std::span<const double> a, std::span<const double> b,
                    std::span<const std::size_t> partners, std::size_t columns, std::size_t most_rows) {
  const Paired paired{a, b, partners, columns};
  TimeShift best{0, paired.differenceAt(0, kInfinite)};
  for (long long by = 1; by <= static_cast<long long>(most_rows) && best.remaining > 0; ++by) {
    for (const long long shift : {by, -by}) {
      const double remaining = paired.differenceAt(shift, best.remaining);
      if (remaining < best.remaining) best = {shift, remaining};
    }
  }
  return best;
}

}  // namespace fissure
