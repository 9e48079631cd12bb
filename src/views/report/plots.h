#pragma once

#include <cstddef>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The plots over time that these runs have data for, in the page's order: one a quantity, and one a tool,
/// clamp, gauge or body where the quantity is theirs; all runs in each. A list of
///   {id, section, title, note, unit, from_zero, far_apart, select, preferred, constant_zero, missing: [run],
///    variants: [{label, series: [{run, rows: [steps from one row to the next], values}]}]}
/// `select` names the axis whose labels are the variants ("law", "xyz"), "" where there is one. `missing`
/// are runs that have the quantity without any value. A quantity that is 0 throughout in every run has no
/// variants. Lengths are in mm, others in the unit's prefix that fits. At most about `most_points` points in
/// all, smallest and largest values kept (series.h). Throws InputError when a series cannot be read.
PageJson plotsJson(const std::vector<ReportRun>& runs, std::size_t most_points);

}  // namespace fissure
