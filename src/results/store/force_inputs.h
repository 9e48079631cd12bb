#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/state.h"

namespace fissure {

/// The arguments of a run's force laws, in the order of its steps.
struct ForceInputs {
  std::vector<std::string> laws;       ///< names of the laws
  std::vector<double> times_s;         ///< times of the recorded steps
  std::vector<std::size_t> row_sizes;  ///< [step] number of colliding triangles
  std::vector<LawInput> inputs;        ///< [observation x number of laws + law], step after step
};

/// Reads the `force_inputs` of one run from a result. Throws InputError when the file is missing, damaged or
/// no result, or when the scenario did not ask for them (`record: {force_inputs: true}`).
ForceInputs readForceInputs(const std::filesystem::path& file, const std::string& pipeline);

}  // namespace fissure
