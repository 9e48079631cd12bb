#pragma once

#include "main/command.h"
#include "slurm/sweep_slurm.h"

namespace fissure {

/// Adds the options of all members but dry_run; `options` must outlive `command`.
void addSlurmOptions(Command command, SlurmOptions& options);

/// Throws InputError when any of these options is given, for engines other than Slurm.
void refuseSlurmOptions(const SlurmOptions& options);

}  // namespace fissure
