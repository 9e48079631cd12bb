#include "elastic/instruction_set.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace fissure {

std::string nameOf(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::baseline:
      break;
  }
  return "baseline";
}

std::vector<InstructionSet> supportedInstructionSets() {
  std::vector<InstructionSet> sets = {InstructionSet::baseline};
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) sets.push_back(InstructionSet::avx2);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("avx512f") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    sets.push_back(InstructionSet::avx512);
#endif
  return sets;
}

InstructionSet chosenInstructionSet() {
  const std::vector<InstructionSet> sets = supportedInstructionSets();
  const char* wanted = std::getenv("FISSURE_INSTRUCTIONS");
  if (wanted == nullptr) return sets.back();
  const auto found =
      std::find_if(sets.begin(), sets.end(), [&](InstructionSet set) { return nameOf(set) == wanted; });
  if (found != sets.end()) return *found;
  std::string names;
  for (const InstructionSet set : sets) names += (names.empty() ? "" : ", ") + nameOf(set);
  throw std::invalid_argument("FISSURE_INSTRUCTIONS is '" + std::string(wanted) +
                              "', which is none of what this machine supports: " + names);
}

const ElementKernels& elementKernels([[maybe_unused]] InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::avx512) return kAvx512Kernels;
  if (set == InstructionSet::avx2) return kAvx2Kernels;
#endif
  return kBaselineKernels;
}

}  // namespace fissure
