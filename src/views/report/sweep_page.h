#pragma once

#include <filesystem>
#include <string>

#include "report/report_run.h"

namespace fissure {

/// What the report page of a sweep's table shows. Above 10,000 runs, or fewer where there are more than 64
/// quantities, the page has a sample of them that depends on nothing but their number, and says so; counts of
/// how runs ended are of all. 10,000 runs stay below 5 MB. Throws InputError when the table cannot be read.
PageJson sweepPage(const std::filesystem::path& file, const std::string& program);

}  // namespace fissure
