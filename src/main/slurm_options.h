#pragma once

#include "main/command.h"
#include "slurm/sweep_slurm.h"

namespace fissure {

/// All but dry_run.
void addSlurmOptions(Command command, SlurmOptions& options);

/// For another engine: throws InputError when any is given.
void refuseSlurmOptions(const SlurmOptions& options);

}  // namespace fissure
