#pragma once

#include <cstddef>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The plots over time for which these runs have data, in the page's order: one per quantity, or one per
/// tool, clamp, gauge or body where the quantity has such an axis, each with all runs. A list of
///   {id, section, title, note, unit, from_zero, far_apart, select, preferred, constant_zero, missing: [run],
///    variants: [{label, series: [{run, rows: [steps from one row to the next], values}]}]}
/// `select` names the axis whose labels are the variants ("law", "xyz"); "" where there is only one.
/// `missing` names runs that have the quantity but no values. A quantity that is 0 at all times in every run
/// has no variants. Lengths are in mm, other quantities in their unit with an SI prefix. There are at most
/// about `most_points` points in all; smallest and largest values are kept (series.h). Throws InputError when
/// a series cannot be read.
PageJson plotsJson(const std::vector<ReportRun>& runs, std::size_t most_points);

}  // namespace fissure
