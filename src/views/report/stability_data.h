#pragma once

#include "report/report_run.h"

namespace fissure {

/// What the page of a study of stability shows, of the contents of study.json: classes with how many cells
/// have each, panels whose cells and boundaries have a place (`row`, from below; `x`, a number along the last
/// axis, or the index of a listed value). Throws InputError, without a file, for what `fissure study
/// stability` does not write.
PageJson stabilityData(const PageJson& study);

}  // namespace fissure
