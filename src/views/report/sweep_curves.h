#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "report/report_run.h"
#include "table/sweep_table.h"

namespace fissure {

/// A number that depends on nothing but `number` and looks random: the mixing of splitmix64 (Steele, Lea and
/// Flood 2014). Runs in its order are spread evenly over a grid, however its axes are ordered.
std::uint64_t scattered(std::uint64_t number);

/// Which runs of a table a page shows, ascending, and what is known of them: all lists are as long.
struct ShownRuns {
  std::vector<std::size_t> runs;
  std::vector<std::size_t> pipeline;  ///< number of its name
  std::vector<bool> good;
  std::vector<std::size_t> first;  ///< places in `runs` whose own curves come before others'
};

/// The curves of a page: {times_s, every, stored, rows: {u16}, tracks: [{curve, law, unit, long_name,
/// bands: [{pipeline, low, median, high}], low: {f32}, high: {f32}, values: {u16}}], measured}. A track is a
/// curve, or a curve of one law. `times_s` are every `every`-th of the `stored` instants, at most 96. Bands
/// are the 10 %, 50 % and 90 % quantiles over the good runs of a pipeline that have a value. `rows` says for
/// which places of the shown runs `values` are held, as many as 0.8 MB take: `first`, then others in
/// scattered() order; values from 0 to 65534 go from `low` to `high` of their row, 65535 is missing. null
/// where the table has no curves.
PageJson sweepCurves(const SweepTable& table, const ShownRuns& shown);

}  // namespace fissure
