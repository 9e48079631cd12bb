#define FISSURE_LANE_WIDTH 2
#include "elastic/lanes_measures.h"
#include "elastic/lanes_move.h"
#include "elastic/lanes_passes.h"

namespace fissure {

const ElementKernels kBaselineKernels = {elementForces, elementVolumeStrains, moveVertices, elementEnergy,
                                         elementStretch};

}  // namespace fissure
