#pragma once

#include <string>
#include <vector>

#include "elastic/element_kernels.h"

namespace fissure {

enum class InstructionSet { baseline, avx2, avx512 };

/// What this machine and this build support, from the narrowest to the widest; baseline always.
std::vector<InstructionSet> supportedInstructionSets();

/// The widest supported one, or the one that the environment's FISSURE_INSTRUCTIONS names: baseline, avx2 or
/// avx512. Throws std::invalid_argument, with one line, for any other value and for one that is not supported
/// here.
InstructionSet chosenInstructionSet();

/// For a supported instruction set.
const ElementKernels& elementKernels(InstructionSet set);

std::string nameOf(InstructionSet set);

}  // namespace fissure
