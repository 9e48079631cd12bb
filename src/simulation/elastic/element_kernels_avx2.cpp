#ifdef __x86_64__

#define FISSURE_LANE_WIDTH 4
#include "elastic/lanes_measures.h"
#include "elastic/lanes_move.h"
#include "elastic/lanes_passes.h"

namespace fissure {

const ElementKernels kAvx2Kernels = {elementForces, elementVolumeStrains, moveVertices, elementEnergy,
                                     elementStretch};

}  // namespace fissure

#endif
