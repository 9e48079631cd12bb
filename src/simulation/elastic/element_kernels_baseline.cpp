#define FISSURE_LANE_WIDTH 2
#include "elastic/lanes_measures.h"

namespace fissure {

const ElementKernels kBaselineKernels = kKernels;

}  // namespace fissure
