#pragma once

#include <string>
#include <vector>

#include "elastic/element_kernels.h"

namespace fissure {

/// An instruction set for which the passes over elements are compiled.
enum class InstructionSet { baseline, avx2, avx512 };

/// The instruction sets that this machine and this build support, from the narrowest to the widest; always
/// with baseline.
std::vector<InstructionSet> supportedInstructionSets();

/// The instruction set that the environment variable FISSURE_INSTRUCTIONS names (baseline, avx2 or avx512),
/// else the widest supported one. Throws std::invalid_argument, with one line, for any other value and for
/// one that is not supported here.
InstructionSet chosenInstructionSet();

/// The passes for a supported instruction set.
const ElementKernels& elementKernels(InstructionSet set);

std::string nameOf(InstructionSet set);

}  // namespace fissure
