#ifdef __x86_64__

#define FISSURE_LANE_WIDTH 4
#include "elastic/lanes_measures.h"

namespace fissure {

const ElementKernels kAvx2Kernels = kKernels;

}  // namespace fissure

#endif
