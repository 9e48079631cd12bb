// What comparing two results costs, beside reading them.
#include <cmath>
#include <numeric>

#include "batch.h"
#include "cases.h"
#include "compare/difference.h"

namespace fissure::bench {

namespace {

constexpr std::size_t kRows = 1000;
constexpr std::size_t kColumns = 3 * 66;  // the positions of the coarse sphere
constexpr std::size_t kShift = 20;        // rows each way
constexpr int kCalls = 9;

/// A travelling wave; `late`: by so many rows.
std::vector<double> wave(double late) {
  std::vector<double> values;
  for (std::size_t row = 0; row < kRows; ++row)
    for (std::size_t column = 0; column < kColumns; ++column)
      values.push_back(
          std::sin(0.01 * (static_cast<double>(row) - late) + 0.1 * static_cast<double>(column)));
  return values;
}

double difference(benchmark::State& state) {
  const std::vector<double> a = wave(0), b = wave(3);
  Batch batch;
  for (int i = 0; i < kCalls; ++i) {
    DifferenceMeter meter(kColumns, {});
    batch.time([&] { meter.add(a, b); });
    if (meter.result().rows != kRows) throw std::logic_error("not all rows were compared");
  }
  state.counters["values"] = static_cast<double>(a.size());
  state.counters["allocations"] = batch.allocationCount() / batch.size();
  return batch.median_s();
}

double shift(benchmark::State& state) {
  const std::vector<double> a = wave(3), b = wave(0);
  std::vector<std::size_t> partners(kRows);
  std::iota(partners.begin(), partners.end(), std::size_t{0});
  Batch batch;
  for (int i = 0; i < kCalls; ++i) {
    TimeShift found;
    batch.time([&] { found = bestShift(a, b, partners, kColumns, kShift); });
    if (found.rows != 3) throw std::logic_error("not the shift that was made");
  }
  state.counters["values"] = static_cast<double>(a.size());
  state.counters["allocations"] = batch.allocationCount() / batch.size();
  return batch.median_s();
}

}  // namespace

void addCompareCases() {
  addCase("compare/difference", difference);
  addCase("compare/shift", shift);
}

}  // namespace fissure::bench
