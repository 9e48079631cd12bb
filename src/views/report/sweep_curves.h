#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "report/report_run.h"
#include "table/sweep_table.h"

namespace fissure {

/// A pseudo-random number that depends only on `number`: the mixing of splitmix64 (Steele, Lea and Flood
/// 2014). Runs sorted by it are spread evenly over a grid, whatever the order of its axes.
std::uint64_t scattered(std::uint64_t number);

/// The runs of a table that a page shows, ascending. The first three lists have one entry per run.
struct ShownRuns {
  std::vector<std::size_t> runs;
  std::vector<std::size_t> pipeline;  ///< index of its pipeline's name
  std::vector<bool> good;
  std::vector<std::size_t> first;  ///< indices in `runs` of those whose curves have priority
};

/// The curves of a page: {times_s, every, stored, rows: {u16}, tracks: [{curve, law, unit, long_name, bands:
/// [{pipeline, low, median, high}], low: {f32}, high: {f32}, values: {u16}}], measured}. A track is a curve,
/// or a curve of one law. `times_s` has every `every`-th of the `stored` times, at most 96. Bands are the 10
/// %, 50 % and 90 % quantiles over the good runs of a pipeline that have a value. `rows` lists the shown runs
/// (by index) for which `values` are stored, as many as fit into 0.8 MB: those of `first`, then others in the
/// order of scattered(). Values from 0 to 65534 are linear between `low` and `high` of their row; 65535 is
/// missing. null where the table has no curves.
PageJson sweepCurves(const SweepTable& table, const ShownRuns& shown);

}  // namespace fissure
