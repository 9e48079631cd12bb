#pragma once

#include <string>
#include <vector>

namespace fissure {

/// Whether options of sbatch say where a job's output goes.
bool nameOutput(const std::vector<std::string>& options);

/// What a user gives to sbatch for both jobs of a sweep. Throws InputError for what would break them: the
/// array and its CPUs (chosen elsewhere), waiting for the end, other clusters (the limits and the queue of
/// one are asked), and a word that sbatch would take for the job's script; also where the environment says
/// so. Spellings that sbatch takes are known (-a1-5, --arr=1-5, -Ha1-5); its options are those of
/// Slurm 22.05.
void refuseUnfitOptions(const std::vector<std::string>& options);

}  // namespace fissure
