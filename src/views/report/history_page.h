#pragma once

#include <string>

#include "report/bench_history.h"
#include "report/report_run.h"

namespace fissure {

/// The data of the page that shows benchmarks over commits: a curve a benchmark and machine, steps, counters.
/// `program` as for resultPage().
PageJson historyPage(const std::string& title, const std::string& program, const BenchHistory& history);

}  // namespace fissure
