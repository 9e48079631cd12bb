#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/state.h"

namespace fissure {

/// What the force laws of a run saw, in the order of its steps.
struct ForceInputs {
  std::vector<std::string> laws;       ///< their names
  std::vector<double> times_s;         ///< of each recorded step
  std::vector<std::size_t> row_sizes;  ///< colliding triangles of each step
  std::vector<LawInput> inputs;        ///< observation x number of laws + law; steps behind one another
};

/// Reads the `force_inputs` of one pipeline's run from a result. Throws InputError when the file is missing,
/// damaged or none, or the run was not asked for them (`record: {force_inputs: true}`).
ForceInputs readForceInputs(const std::filesystem::path& file, const std::string& pipeline);

}  // namespace fissure
