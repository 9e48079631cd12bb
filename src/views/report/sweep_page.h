#pragma once

#include <filesystem>
#include <string>

#include "report/report_run.h"

namespace fissure {

/// The data of the report page of a sweep's table; `program` as for resultPage(). With more than 10,000 runs,
/// or fewer where there are more than 64 quantities, the page has a sample of the runs, which depends only on
/// their number, and says so; numbers of failures are those of all runs. A page of 10,000 runs stays below 5
/// MB. Throws InputError when the table cannot be read.
PageJson sweepPage(const std::filesystem::path& file, const std::string& program);

}  // namespace fissure
