#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "study/stability_study.h"

namespace fissure {

/// How many cells of a study have each class; those that were not run yet have none.
std::map<StabilityClass, std::size_t> countClasses(const StabilityStudy& study);

/// Writes into the study's folder: cells.csv (a row a cell), boundaries.csv, study.json (the same with axes
/// and criteria, for pages and scripts) and, for each class that occurs, typical/<class>.yaml, a scenario
/// that runs as it is and gives the cell in the middle of those of this class. Throws RunError when writing
/// fails.
void writeStability(const StabilityStudy& study);

}  // namespace fissure
