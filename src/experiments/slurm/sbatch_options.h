#pragma once

#include <string>
#include <vector>

namespace fissure {

/// Whether these options of sbatch name a file for a job's output.
bool nameOutput(const std::vector<std::string>& options);

/// Checks the options that a user passes to sbatch for both jobs of a sweep. Throws InputError for options
/// that would break the jobs, also where the environment sets them: the array and its CPUs (chosen
/// elsewhere), waiting for the end, other clusters (only the limits and the queue of one are known), and a
/// word that sbatch would take for the job's script. All spellings that sbatch accepts are recognised (-a1-5,
/// --arr=1-5, -Ha1-5), with the options of Slurm 22.05.
void refuseUnfitOptions(const std::vector<std::string>& options);

}  // namespace fissure
