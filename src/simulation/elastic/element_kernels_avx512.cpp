#ifdef __x86_64__

#define FISSURE_LANE_WIDTH 8
#include "elastic/lanes_measures.h"

namespace fissure {

const ElementKernels kAvx512Kernels = kKernels;

}  // namespace fissure

#endif
